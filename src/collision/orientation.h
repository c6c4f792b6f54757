// On which side points are, exactly: signs of areas and volumes of points whose coordinates are floats.
#pragma once

#include <glm/vec3.hpp>

namespace nuno {

// The sign of (b - a) x (c - a) . (d - a): positive where d is on the side of the normal of the face a, b, c; 0 where
// all four are in one plane.
int volume_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

// The sign of ((b - a) x (c - a))[axis]: positive where a, b, c, seen against that axis, turn to the left.
int area_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int axis);

}  // namespace nuno
