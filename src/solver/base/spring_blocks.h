// The springs of each vertex as the CPU reads them: blocks of kLanes vertices side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "model/spring_weights.h"
#include "model/wide.h"

namespace nuno {

// Of one slot of one block. Where the neighbours of its lanes follow one another (as they do in rows of a grid,
// whichever file it came from), the run starts at the neighbour of lane 0 and is read as one vector; it may start up to
// kLanes - 1 before the first vertex or reach as far past the last, where lanes without a spring point. Elsewhere it is
// kGather and each lane reads its own neighbour.
using Run = std::int32_t;

struct SpringBlocks
{
    static constexpr Run kGather = INT32_MIN;

    std::vector<std::uint32_t> first_slot;         // of each block in `runs`, and one past the last
    std::vector<Run> runs;                         // slots in which no lane has a spring are left out
    std::vector<std::uint32_t> neighbours;         // kLanes a slot
    std::vector<float> stiffness, tension, axial;  // kLanes a slot, as SpringEntries

    int block_count() const { return static_cast<int>(first_slot.size()) - 1; }
};

SpringBlocks make_spring_blocks(const SpringEntries& entries);

}  // namespace nuno
