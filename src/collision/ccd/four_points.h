// The four points of a pair of primitives, as the continuous tests take them.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace nuno {

enum class PairKind
{
    vertex_face,  // vertex, then the face's three
    edge_edge,    // the ends of one edge, then those of the other
};

using FourPoints = std::array<glm::dvec3, 4>;

}  // namespace nuno
