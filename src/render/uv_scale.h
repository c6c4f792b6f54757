// How large the texture of a sheet is on it.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nuno {

// Metres of cloth for each unit of u and of v, averaged over the area of the faces. `rest`: positions [m], one a
// vertex as `uvs`. (1, 1) where no face has an area in both.
glm::vec2 metres_of_uv(std::span<const glm::uvec3> faces, std::span<const glm::vec3> rest,
                       std::span<const glm::vec2> uvs);

}  // namespace nuno
