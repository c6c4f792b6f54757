// A grid sheet as the tree sees it: cells in rows and columns, with the faces of each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/cloth_model.h"

namespace nuno {

// Cell (i, j) has the corners a = (i, j), b = (i + 1, j), c = (i, j + 1), d = (i + 1, j + 1). In a regular patch all
// cells are cut from a to d: face 0 is (a, c, d) and face 1 is (a, d, b), their corners in any order.
struct GridPatch
{
    int columns = 0, rows = 0;  // of cells
    bool is_regular = false;
    std::uint32_t first_vertex = 0;
    bool is_in_order = false;             // vertex (i, j) is first_vertex + j (columns + 1) + i
    std::vector<std::uint32_t> vertices;  // by (i, j)
    std::vector<std::uint32_t> faces[2];  // of cell (i, j) at j face_stride() + i; some more at the end may be read
    std::vector<std::uint32_t> node_of;   // level-0 node of each square of 2 x 2 cells, row by row
    std::uint32_t first_face = 0, face_count = 0;

    int face_stride() const { return columns; }
    int node_columns() const { return (columns + 1) / 2; }
    int node_rows() const { return (rows + 1) / 2; }
    std::uint32_t vertex(int i, int j) const
    {
        return vertices[std::size_t(j) * std::size_t(columns + 1) + std::size_t(i)];
    }
};

// The sheet as a patch; nothing where it is no grid of two faces a cell. Columns may be taken in reverse, so that a
// sheet whose cells are all cut the other way is regular too.
std::optional<GridPatch> make_grid_patch(const Sheet& sheet, std::span<const glm::uvec3> faces);

}  // namespace nuno
