// How stiff each spring is for given parameters, and the springs of each vertex as both backends gather them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// Force on the spring's first end, d to the other: axial (|d| - l0) d / |d| + plate d. Both in N/m; plate, the share of
// this pair in the linear plate bending, may be negative.
struct SpringWeight
{
    float axial, plate;
};

// One a spring of the model. springs: the raw stiffness of its kind. fabric_springs: from the fabric constants, so that
// a finer grid is the same cloth (in a cell dx by dy, with G the shear modulus: shear G (dx^2 + dy^2) / (2 dx dy), weft
// (C22 - G dx^2 / dy^2) dy / dx, warp alike, not below 0; C12 comes out as G); an edge of a mesh gets 8/9 of the tensile
// stiffness along it times its share, which is exact for equal triangles of an isotropic cloth with Poisson's ratio 1/3.
// continuum: no axial part.
std::vector<SpringWeight> spring_weights(const ClothModel& model, const SimParams& params);

// True where spring_weights (and so spring_entries) of the two are different.
bool spring_weights_differ(const SimParams& a, const SimParams& b);

// The entries of the spring table (slot * vertex_count + vertex) that have a force, slots without any left out:
//   force = (stiffness - tension / |d|) d,  stiffness = axial + plate, tension = axial l0,
// and `axial` for the damper along the spring. All 0 where there is no spring. slot_count is a multiple of 4.
struct SpringEntries
{
    std::uint32_t vertex_count = 0;
    int slot_count = 0;
    std::vector<std::uint32_t> neighbours;
    std::vector<float> stiffness, tension, axial;
};

SpringEntries spring_entries(const ClothModel& model, std::span<const SpringWeight> weights);
SpringEntries spring_entries(const ClothModel& model, const SimParams& params);

// How stiff a method makes the springs: the weights, and whether those for two sets of parameters are different.
struct SpringRule
{
    std::vector<SpringWeight> (*weights)(const ClothModel& model, const SimParams& params);
    bool (*differ)(const SimParams& a, const SimParams& b);
};
inline constexpr SpringRule kTrueSprings{spring_weights, spring_weights_differ};
inline constexpr SpringRule kNoSprings{nullptr, nullptr};  // of methods that have their own

}  // namespace nuno
