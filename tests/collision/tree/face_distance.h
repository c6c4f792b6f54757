// How far two triangles are from each other, in double, by the book: shares nothing with what it checks.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace nuno {

using Triangle = std::array<glm::dvec3, 3>;

// The least distance of a point of one to a point of the other; 0 where they meet. Triangles without area are segments
// or points.
double triangle_distance(const Triangle& a, const Triangle& b);

}  // namespace nuno
