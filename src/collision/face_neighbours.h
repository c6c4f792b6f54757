// Faces with a common vertex: a list of the mesh, which no tree has to find.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/tree_node.h"

namespace nuno {

// All pairs of faces, of vertices below `vertex_count`, that share a vertex: a < b, each once, in order. Error where a
// vertex has so many faces that the list would be too long.
std::vector<FacePair> neighbouring_faces(std::span<const glm::uvec3> faces, std::uint32_t vertex_count);

}  // namespace nuno
