// What culling leaves out of the pairs of a cloth, held against exact distances.
#pragma once

#include <cstddef>

#include "collision/tree/tree_cases.h"

namespace nuno {

struct CullingOutcome
{
    std::size_t in_reach = 0;        // pairs whose boxes overlap
    std::size_t left_out = 0;        // of them
    std::size_t near = 0;            // that come within the distance at one of the times
    std::size_t lost = 0;            // of those, not found
    double nearest_left_out = 1e30;  // [m]
    bool proven_apart = false;
};

// Of the pairs that are found on a moving way only some are looked at: they are for the count of near ones alone.
CullingOutcome culling_outcome(const TreeCase& cloth, const Poses& poses, float distance, Culling culling);

}  // namespace nuno
