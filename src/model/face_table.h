// Faces as both backends compute forces on them: each at rest, and for each vertex the corners that meet in it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/cloth_model.h"
#include "model/formulas.h"

namespace nuno {

// Which forces on faces the parameters ask for.
struct FaceForces
{
    bool membrane, air, gusts;
    bool any() const { return membrane || air; }
    bool operator==(const FaceForces&) const = default;
};
FaceForces face_forces(const SimParams& params);

// Each face at rest, warp along ClothModel::face_warps. A face thinner than 1e-5 of its longest edge has no shape that
// a float holds: it gets an area, but no gradients, so that its membrane exerts no force. mass_area is less than the area
// where a corner is lighter than the faces about it.
std::vector<formulas::FaceRest> face_rests(const ClothModel& model);

// ELLPACK: entry (slot, vertex) at slot * vertex_count + vertex is corner * face_count + face, faces in ascending
// order; past the last of a vertex it is 3 * face_count. slot_count is a multiple of 4.
struct CornerTable
{
    std::uint32_t vertex_count, face_count;
    int slot_count = 0;
    std::vector<std::uint32_t> corners;
};
CornerTable make_corner_table(const ClothModel& model);

// The constants of the membrane; Error where C12^2 > C11 C22, since then some stretch would give energy away.
formulas::MembraneConstants membrane_constants(const SimParams& params);

// What acts on a face: shared by both backends.
formulas::Air air_of(const SimParams& params);

}  // namespace nuno
