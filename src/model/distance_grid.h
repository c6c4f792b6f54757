// A closed mesh as a body: signed distances to it at the nodes of a grid.
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "model/triangle_mesh.h"

namespace nuno {

// Node (i, j, k) lies at origin + cell (i, j, k); its distance [m], negative inside, is
// values[(k (cells.y + 1) + j) (cells.x + 1) + i].
struct DistanceGrid
{
    glm::vec3 origin{0, 0, 0};  // [m], in the mesh's coordinates
    float cell = 1;             // [m]
    glm::ivec3 cells{1, 1, 1};
    std::vector<float> values;
};

// Error, prefixed by `where`, for a mesh that does not enclose a volume: names the first edge that does not have exactly
// one face on each side, running opposite ways, or says that the faces look inwards.
void check_closed(const TriangleMesh& mesh, std::string_view where);

// Distances to a closed mesh, exact at the nodes (nearest triangle; sign by the angle-weighted normals of Baerentzen and
// Aanaes 2005). `cell` [m]; 0: a 48th of the mesh's longest side. The grid reaches two cells or more past the mesh on
// each side. Error, prefixed by `where`, where the mesh is not closed or the grid has more than 16 million nodes.
DistanceGrid make_distance_grid(const TriangleMesh& mesh, float cell, std::string_view where);

}  // namespace nuno
