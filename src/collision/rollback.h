// The last resort of a pass: clusters of what would still meet go back along their way, which is free at its start.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/impact_zone.h"

namespace nuno {

struct Clusters
{
    std::uint32_t count = 0, largest = 0;  // largest: of vertices
    std::uint32_t held_back = 0;           // vertices without mass, on handles that move, that went back too
};

// Puts every vertex of an impact back to `kept` times the earliest time of the impacts that hang together with it, from
// `end` towards `start` [m]: end = start + kept time (end - start), rounded to float. Marks them in `moved`, one a
// vertex.
Clusters roll_back(std::span<const Impact> impacts, double kept, std::span<const glm::vec4> start,
                   std::span<glm::vec4> end, std::span<std::uint8_t> moved);

}  // namespace nuno
