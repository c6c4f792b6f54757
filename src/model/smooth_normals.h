// Smooth normals of a mesh on the CPU: for files, and what the kernel of the pictures is tested against.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// One a vertex, of unit length: the mean of its faces weighted by their areas. (0, 0, 1) where those have none. xyz of
// the positions count; faces are counter-clockwise seen from the front.
std::vector<glm::vec3> smooth_normals(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces);

}  // namespace nuno
