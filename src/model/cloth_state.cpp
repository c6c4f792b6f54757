// Start of a cloth, and checks of its state.
#include "model/cloth_state.h"

#include <random>

#include "core/hash.h"

namespace nuno {

float inverse_mass(const ClothModel& model, std::uint32_t vertex, float areal_density)
{
    return 1.0f / (model.areas[vertex] * areal_density);
}

ClothState start_state(const ClothModel& model, const SimParams& params)
{
    std::mt19937 random(static_cast<std::uint32_t>(params.seed));
    // Written out, since the standard's distributions differ between libraries: 24 random bits to -1 .. 1.
    const auto shift = [&] {
        return params.jitter * (static_cast<float>(random() >> 8) * (2.0f / 16777215.0f) - 1.0f);
    };
    ClothState state;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v) {
        glm::vec3 p = model.start_positions[v];
        if (params.seed != 0 && !model.pinned[v]) {
            p.x += shift();
            p.y += shift();
            p.z += shift();
        }
        state.positions.emplace_back(p, model.pinned[v] ? 0.0f : inverse_mass(model, v, params.areal_density));
        state.velocities.emplace_back(0, 0, 0, model.areas[v]);
    }
    return state;
}

std::uint64_t state_hash(const ClothState& state)
{
    Fnv1a hash;
    for (const auto* values : {&state.positions, &state.velocities})
        for (const glm::vec4& value : *values) hash.add(&value, 3 * sizeof(float));
    return hash.value();
}

std::optional<std::uint32_t> first_lost(std::span<const glm::vec4> values)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        if (is_lost(values[i].x) || is_lost(values[i].y) || is_lost(values[i].z)) return static_cast<std::uint32_t>(i);
    return std::nullopt;
}

}  // namespace nuno
