// Which vertices springs join, and how springs share the work of the cloth around them.
#pragma once

#include <span>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// The seed's neighbourhood (fig 2.1) of a grid sheet: threads to the 4 neighbours, shear to the 4 diagonal ones, bend to
// the 4 two cells away. Its plate terms are those of a thin plate by finite differences,
//   E = 1/2 sum D_weft |x(i-1) - 2 x(i) + x(i+1)|^2 dy/dx^3 + (warp alike) + twist |x00 - x10 - x01 + x11|^2 / (dx dy),
// alike in every direction of the sheet, and D (not 3 D) against small bending; each is a sum of springs of no rest
// length, since |sum c_i x_i|^2 = - sum_(i<j) c_i c_j |x_i - x_j|^2 where the c_i sum to 0.
void append_grid_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions, const Sheet& sheet);

// Threads along every edge of the faces, hinge springs between the corners that face each other across an inner edge;
// the plate terms are the quadratic bending energy of Bergou et al. 2006, E = D / (2 (A1 + A2)) |sum c_i x_i|^2 a hinge.
// `warps`: direction of the warp in each face.
void append_mesh_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions,
                         std::span<const glm::uvec3> faces, std::span<const glm::vec3> warps);

// Unit direction of the warp in a face at rest: where v of the texture grows, or, without texture coordinates, the
// longest edge's.
glm::vec3 face_warp(const TriangleMesh& mesh, const glm::uvec3& face);

}  // namespace nuno
