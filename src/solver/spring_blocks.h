// The spring table as the CPU reads it: blocks of kLanes vertices side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "model/spring_table.h"
#include "model/wide.h"

namespace nuno {

// One slot of one block. Where the neighbours of its lanes follow one another (as they do in rows of a grid, whichever
// file it came from), `run` is the neighbour of lane 0 and they are read as one vector; it may lie up to kLanes - 1
// before the first vertex or reach as far past the last, where lanes without a spring point. Elsewhere `run` is kGather
// and each lane reads its own neighbour.
struct SpringBlockSlot
{
    std::int32_t run;
    std::int32_t kind;  // SpringKind
};

struct SpringBlocks
{
    static constexpr std::int32_t kGather = INT32_MIN;

    std::vector<std::uint32_t> first_slot;  // of each block in `slots`, and one past the last
    std::vector<SpringBlockSlot> slots;     // slots in which no lane has a spring are left out
    std::vector<float> rest_lengths;        // kLanes a slot; negative: no spring
    std::vector<std::uint32_t> neighbours;  // kLanes a slot
};

SpringBlocks make_spring_blocks(const SpringTable& table);

}  // namespace nuno
