// Finds the rows and columns of a triangle mesh that is a regular grid, whatever its file made of the order of
// vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/triangle_mesh.h"

namespace nuno {

struct RecoveredGrid
{
    int columns, rows;
    std::vector<std::uint32_t> order;  // vertex at column i, row j is order[j columns + i]; SheetSource::grid_order
};

// The grid that the mesh is: each cell two triangles, cut along either diagonal; all cells alike, to 1 part in 1000, in
// the length of each pair of sides and of both diagonals (a cell is a rectangle, its diagonals its longest edges); at
// least 2 x 2 vertices; the sheet may be bent. Columns run along growing u and rows along falling v where the texture
// says so, else along x, and down or along z. Nothing for any other mesh.
std::optional<RecoveredGrid> recover_grid(const TriangleMesh& mesh);

}  // namespace nuno
