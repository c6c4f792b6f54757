// The springs of each vertex as the CPU reads them: blocks of kLanes vertices side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "model/spring_weights.h"
#include "solver/base/vertex_lanes.h"

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
};

SpringBlocks make_spring_blocks(const SpringEntries& entries);

// What the neighbours of a slot have in `lanes`.
NUNO_WIDE_INLINE WideVec3 load_neighbours(const SpringBlocks& springs, std::uint32_t slot, const Lanes3& lanes)
{
    const Run run = springs.runs[slot];
    return run == SpringBlocks::kGather ? gather(lanes, &springs.neighbours[slot * kLanes]) : load(lanes, run);
}

}  // namespace nuno
