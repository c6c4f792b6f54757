// Strain, speed, culling and sleep as colours.
#include "app/overlay_heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/round_up.h"
#include "render/colour_map.h"

namespace nuno {
namespace {

constexpr double kLeastStrain = 0.1, kLeastSpeed = 0.01;  // at the top of a bar [%, m/s]
// The percentage of vertices whose numbers a bar that follows them reaches at least: a few at pins have many times more.
constexpr std::size_t kShown = 98;
// Of colours that stand for one of two states.
constexpr float kAwake = 0.2f, kAsleep = 0.85f;

// Of numbers of the vertices, on a bar whose top is asked for, or follows them where that is 0.
ClothHeat on_bar(std::vector<float> values, LegendScale scale, double asked_top, double least, OverlayLegend& legend)
{
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    scale.largest = double(sorted.back());
    scale.top = asked_top > 0 ? asked_top : round_top(double(sorted[sorted.size() * kShown / 100]), least);
    for (float& value : values) value /= static_cast<float>(scale.top);
    legend.scale = std::move(scale);
    return {std::move(values), false};
}

std::vector<float> speeds(std::span<const glm::vec4> velocities)
{
    std::vector<float> values;
    for (const glm::vec4& v : velocities) values.push_back(glm::length(glm::vec3(v)));
    return values;
}

std::vector<float> in_percent(std::vector<float> values)
{
    for (float& value : values) value *= 100;
    return values;
}

ClothHeat culled_patches(Simulation& simulation, TreePicture* tree, OverlayLegend& legend)
{
    const SimParams& params = simulation.params();
    if (!tree || params.culling == Culling::none) {
        legend.remarks.emplace_back(tree ? "nothing culled: culling is none"
                                         : "nothing culled: collision here needs no tree");
        return {};
    }
    const ClothModel& model = simulation.model();
    const std::span<const glm::vec4> positions = simulation.state().positions;
    const std::size_t face_count = model.faces.size();
    ClothHeat heat{{}, true};
    std::size_t count = 0;
    const auto top = static_cast<float>(tree->depth() + 1);
    for (const int levels : tree->left_out(positions, contact_query(params, model.faces, positions))) {
        heat.values.push_back(static_cast<float>(levels) / top);
        count += levels > 0;
    }
    legend.rows.push_back({viridis(0), "looked at: may touch what is near"});
    legend.rows.push_back({viridis(1 / top), "culled: cannot touch the faces around it"});
    if (top > 2) legend.rows.push_back({viridis(0.6f), "culled: nor any of a larger patch"});
    legend.rows.push_back({viridis(1), "culled: nor any of the cloth"});
    if (params.culling == Culling::seed) legend.remarks.emplace_back("by the seed's rule, which can be wrong");
    legend.remarks.push_back(
        fmt::format("{} of {} faces culled ({:.0f} %)", count, face_count, 100.0 * double(count) / double(face_count)));
    return heat;
}

ClothHeat sleep(const Simulation& simulation, OverlayLegend& legend)
{
    const bool asleep = simulation.is_asleep();
    legend.rows.push_back({viridis(kAwake), asleep ? "awake" : "awake: now"});
    legend.rows.push_back({viridis(kAsleep), asleep ? "asleep: now" : "asleep"});
    legend.remarks.emplace_back(simulation.params().sleep_motion > 0 ? "all of the cloth sleeps at once, or none of it"
                                                                     : "sleep_motion is 0: it never sleeps");
    return {std::vector<float>(simulation.model().vertex_count(), asleep ? kAsleep : kAwake), false};
}

}  // namespace

std::vector<float> thread_strains(const ClothModel& model, std::span<const glm::vec4> positions)
{
    std::vector<float> strains(model.vertex_count());
    for (const Spring& spring : model.springs) {
        if (!is_thread(spring.kind)) continue;
        const float length = glm::distance(glm::vec3(positions[spring.a]), glm::vec3(positions[spring.b]));
        const float strain = std::abs(length / spring.rest_length - 1);
        for (const std::uint32_t v : {spring.a, spring.b}) strains[v] = std::max(strains[v], strain);
    }
    return strains;
}

double round_top(double largest, double least) { return largest > least ? round_up_125(largest) : least; }

ClothHeat heat_of(const ViewParams& view, Simulation& simulation, TreePicture* tree, OverlayLegend& legend)
{
    switch (view.heat) {
    case Heat::none: break;
    case Heat::strain:
        return on_bar(in_percent(thread_strains(simulation.model(), simulation.state().positions)),
                      {"strain of threads", "%"}, double(view.strain_top), kLeastStrain, legend);
    case Heat::speed:
        return on_bar(speeds(simulation.state().velocities), {"speed", "m/s"}, double(view.speed_top), kLeastSpeed,
                      legend);
    case Heat::culled: return culled_patches(simulation, tree, legend);
    case Heat::asleep: return sleep(simulation, legend);
    }
    return {};
}

}  // namespace nuno
