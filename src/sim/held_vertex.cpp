// A hand that pulls a vertex within what threads and tethers allow.
#include "sim/held_vertex.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kHandStretch = 0.2f;  // of the threads at a held vertex, at most

std::vector<Tether> reach_of(const ClothModel& model, const SimParams& params, std::uint32_t vertex)
{
    const float room = params.tethers == Tethers::none ? kHandStretch : params.tether_stretch;
    std::vector<Tether> reach;
    for (const Sheet& sheet : model.sheets) {
        if (vertex < sheet.first_vertex || vertex >= sheet.first_vertex + sheet.vertex_count) continue;
        const std::vector<Tether> tethers = SheetGeodesics(model, sheet).pin_tethers(model.pinned);
        for (std::size_t i = vertex - sheet.first_vertex; i < tethers.size(); i += sheet.vertex_count)
            if (tethers[i].anchor != Tether::kNone)
                reach.push_back({tethers[i].anchor, tethers[i].length * (1 + room)});
    }
    return reach;
}

}  // namespace

HeldVertex::HeldVertex(const ClothModel& model, const SimParams& params, std::uint32_t vertex, glm::vec3 position)
    : vertex_(vertex), position_(position), target_(position), reach_(reach_of(model, params, vertex))
{
}

void HeldVertex::advance(const ClothModel& model, std::span<const glm::vec4> positions, float duration_s)
{
    const SpringTable& table = model.spring_table;
    glm::vec3 way = target_ - position_;
    way *= std::min(1.0f, kHandSpeed * duration_s / std::max(glm::length(way), 1e-12f));
    for (int slot = 0; slot < table.first_slot[1]; ++slot) {
        const std::size_t entry = static_cast<std::size_t>(slot) * table.vertex_count + vertex_;
        if (table.springs[entry] == SpringTable::kNoSpring) continue;
        const glm::vec3 thread = position_ - glm::vec3(positions[table.neighbours[entry]]);
        const float length = std::max(glm::length(thread), 1e-12f);
        const float longest = (1 + kHandStretch) * model.springs[table.springs[entry]].rest_length;
        const float slack = std::max(longest - length, 0.0f);
        way -= std::max(glm::dot(way, thread) / length - slack, 0.0f) * (thread / length);
    }
    position_ += way;
    for (const Tether& tether : reach_) {
        const glm::vec3 pin(positions[tether.anchor]), away = position_ - pin;
        position_ = pin + away * std::min(1.0f, tether.length / std::max(glm::length(away), 1e-12f));
    }
}

}  // namespace nuno
