// Takes cloth apart that intersects itself, from one pose alone: intersection contour minimisation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/tangle.h"
#include "core/thread_pool.h"

namespace nuno {

struct UntangleResult
{
    std::vector<glm::vec4> positions;  // the pose with the fewest intersections that was found
    TangleCounts before, left;
    int steps = 0;           // taken until that pose
    float largest_move = 0;  // [m] of a vertex, from the pose before
};

// Shortens the lines along which faces cross, step by step, until none is left or no step helps any more. What only
// touches is shaken a little, so that it crosses or does not. Vertices with w = 0 stay; edges are kept at their lengths
// where that can be. The result does not depend on the number of threads.
UntangleResult untangle(TangleSearch& search, std::span<const glm::vec4> positions, ThreadPool& pool);

}  // namespace nuno
