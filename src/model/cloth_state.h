// What changes while a cloth moves.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

struct ClothState
{
    std::vector<glm::vec4> positions;   // xyz [m]; w: inverse mass [1/kg], 0 where pinned
    std::vector<glm::vec4> velocities;  // xyz [m/s]; w: area of cloth that the vertex carries [m2]
};

// The start of a scene: start positions (shifted by SimParams::seed and jitter where seed is not 0), at rest.
ClothState start_state(const ClothModel& model, const SimParams& params);

// Inverse mass [1/kg] of a vertex that is not pinned.
float inverse_mass(const ClothModel& model, std::uint32_t vertex, float areal_density);

// 64-bit hash of the bits of all positions and velocities (xyz), in vertex order.
std::uint64_t state_hash(const ClothState& state);

// Whether a coordinate of a position [m] or a velocity [m/s] is beyond any cloth: 1e6 or more, where single precision
// tells centimetres apart no more, infinite, or no number (shaders/sim/lost.comp).
inline bool is_lost(float a) { return !(std::abs(a) < 1e6f); }

// The first of these with such a coordinate.
std::optional<std::uint32_t> first_lost(std::span<const glm::vec4> values);

}  // namespace nuno
