// Cloth that several tests start from.
#pragma once

#include <cstdint>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// A square grid sheet of `side` m with `count` x `count` vertices in the X-Y plane, its top left corner at the origin.
SheetSource square_sheet(int count, float side, std::vector<std::uint32_t> pins = {});
ClothModel square_cloth(int count, float side, std::vector<std::uint32_t> pins = {},
                        MassLumping lumping = MassLumping::equal);

// The same sheet as a mesh without rows and columns; its vertices shuffled within windows of `window`, if that is over
// 1.
SheetSource square_mesh(int count, float side, std::size_t window = 1);

// A grid_mesh of so many columns and rows with each cell cut along either diagonal, at random: vertices of 4 to 8
// neighbours.
TriangleMesh cut_at_random(TriangleMesh grid, int columns, int rows);

}  // namespace nuno
