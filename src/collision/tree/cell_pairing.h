// Pairs the faces of any mesh up as cells, and puts the cells in an order in which neighbours are near.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/tree_node.h"

namespace nuno {

// A run of faces of a mesh: rest positions [m] of all vertices, all faces, and which of them.
struct FaceRun
{
    std::span<const glm::vec3> rest_positions;
    std::span<const glm::uvec3> faces;
    std::uint32_t first_face, face_count;
};

// Every face of the run in one cell: with the neighbour across its longest edge that is still alone, else by itself.
std::vector<Cell> pair_faces(const FaceRun& run);

// Puts the cells in the order of a balanced tree over their places at rest: any four, sixteen, sixty-four .. of them
// from a multiple of that number on are near one another.
void order_cells(std::vector<Cell>& cells, std::span<const glm::vec3> rest_positions);

}  // namespace nuno
