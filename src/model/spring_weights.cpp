// Stiffness of springs from parameters.
#include "model/spring_weights.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

float raw_stiffness(const SimParams& p, SpringKind kind)
{
    constexpr int shear_group = 1, bend_group = 2;
    switch (spring_group(kind)) {
    case shear_group: return p.shear_stiffness;
    case bend_group: return p.bend_stiffness;
    default: return p.structural_stiffness;
    }
}

// Tensile stiffness [N/m] of the cloth in the direction whose squared cosine to the warp is `c`.
float tensile_stiffness(const SimParams& p, float c)
{
    const float s = 1 - c;
    return p.warp_stiffness * c * c + p.weft_stiffness * s * s + 2 * (p.cross_stiffness + 2 * p.shear_modulus) * c * s;
}

float fabric_stiffness(const SimParams& p, const Spring& spring)
{
    const float ratio = spring.cell_ratio, ratio_sq = ratio * ratio;
    switch (spring.kind) {
    case SpringKind::weft: return std::max(p.weft_stiffness - p.shear_modulus / ratio_sq, 0.0f) * ratio * spring.share;
    case SpringKind::warp: return std::max(p.warp_stiffness - p.shear_modulus * ratio_sq, 0.0f) / ratio * spring.share;
    case SpringKind::shear: return p.shear_modulus * (ratio + 1 / ratio) / 2;
    case SpringKind::edge: return 8.0f / 9.0f * tensile_stiffness(p, spring.warp_share) * spring.share;
    default: return 0;
    }
}

// Stiffness D of a plate against twist that gives `bending_bias` at 45 degrees, not below 0.
float twist_stiffness(const SimParams& p)
{
    return std::max(4 * p.bending_bias - p.bending_warp - p.bending_weft, 0.0f);
}

// Slots of a group without a force are left out.
bool group_has_force(const ClothModel& model, std::span<const SpringWeight> weights, int group)
{
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (spring_group(model.springs[i].kind) == group && (weights[i].axial != 0 || weights[i].plate != 0))
            return true;
    return false;
}

}  // namespace

std::vector<SpringWeight> spring_weights(const ClothModel& model, const SimParams& params)
{
    const glm::vec3 bending(params.bending_warp, params.bending_weft, twist_stiffness(params));
    std::vector<SpringWeight> weights;
    weights.reserve(model.springs.size());
    for (const Spring& spring : model.springs) {
        float axial = 0;
        if (params.internal_model == InternalModel::springs) axial = raw_stiffness(params, spring.kind);
        if (params.internal_model == InternalModel::fabric_springs) axial = fabric_stiffness(params, spring);
        weights.push_back({axial, glm::dot(spring.plate, bending)});
    }
    return weights;
}

bool spring_weights_differ(const SimParams& a, const SimParams& b)
{
    const auto key = [](const SimParams& p) {
        return std::array{float(p.internal_model), p.structural_stiffness, p.shear_stiffness, p.bend_stiffness,
                          p.warp_stiffness,        p.weft_stiffness,       p.cross_stiffness, p.shear_modulus,
                          p.bending_warp,          p.bending_weft,         p.bending_bias};
    };
    return key(a) != key(b);
}

SpringEntries spring_entries(const ClothModel& model, const SimParams& params)
{
    return spring_entries(model, spring_weights(model, params));
}

SpringEntries spring_entries(const ClothModel& model, std::span<const SpringWeight> weights)
{
    const SpringTable& table = model.spring_table;
    SpringEntries entries;
    entries.vertex_count = table.vertex_count;
    for (int group = 0; group < kSpringGroupCount; ++group) {
        if (!group_has_force(model, weights, group)) continue;
        const std::size_t begin = std::size_t(table.first_slot[group]) * table.vertex_count;
        const std::size_t end = std::size_t(table.first_slot[group + 1]) * table.vertex_count;
        entries.slot_count += table.first_slot[group + 1] - table.first_slot[group];
        for (std::size_t i = begin; i < end; ++i) {
            const bool present = table.springs[i] != SpringTable::kNoSpring;
            const SpringWeight w = present ? weights[table.springs[i]] : SpringWeight{0, 0};
            entries.neighbours.push_back(table.neighbours[i]);
            entries.stiffness.push_back(w.axial + w.plate);
            entries.tension.push_back(present ? w.axial * model.springs[table.springs[i]].rest_length : 0.0f);
            entries.axial.push_back(w.axial);
        }
    }
    return entries;
}

}  // namespace nuno
