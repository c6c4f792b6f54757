// What changes while a cloth moves.
#pragma once

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

// The first vertex with a coordinate that is infinite or no number, in position or velocity.
std::optional<std::uint32_t> first_not_finite(std::span<const glm::vec4> values);

}  // namespace nuno
