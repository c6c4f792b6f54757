// Where vertices go in one step of untangling, by two rules that need no history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tangle.h"

namespace nuno {

// Of each vertex; a length of 1 is a whole step.
using Directions = std::vector<glm::dvec3>;

// v over its length; 0 where it has none.
inline glm::dvec3 unit_or_zero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

struct MeshEdge
{
    std::uint32_t a, b;  // a < b
    double length;       // [m]
};

// Adds what shortens the lines along which faces cross.
void add_contour_moves(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces,
                       std::span<const glm::vec4> positions, Directions& ways);

// Adds what takes parts of the cloth that crossings cut off back to the larger part.
void add_side_moves(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces, std::span<const MeshEdge> edges,
                    std::span<const glm::vec4> positions, Directions& ways);

}  // namespace nuno
