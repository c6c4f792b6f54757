// Parts of a scene, left out one by one.
#include "study/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "study/run_measures.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Wall time of the frames of one run, after which the rest of the scene is taken to be alike [ms].
constexpr double kEnoughMs = 2500;
constexpr int kCheckEvery = 8;
// The least share of the cost that is worth leaving out a part.
constexpr double kWorthIt = 0.03;

struct Part
{
    std::string name;
    Setting without;
    bool is_there;
};

std::vector<Part> parts_of(const SimParams& p, const ClothModel& model)
{
    const bool raw = p.internal_model == InternalModel::springs, meets = p.collision != CollisionLevel::none;
    const auto below = [&] {
        const auto level = std::max(std::size_t(1), std::size_t(p.collision)) - 1;
        return std::string(choice_names(CollisionLevel{})[level]);
    };
    const bool blows = p.wind_model == WindModel::aero
                           ? p.wind_x != 0 || p.wind_y != 0 || p.wind_z != 0 || p.gust_speed != 0
                           : p.wind_strength != 0 || p.wind_mean != 0;
    int side = 0;
    for (const Sheet& sheet : model.sheets) side = std::max({side, sheet.columns, sheet.rows});
    const Setting calm = p.wind_model == WindModel::aero
                             ? Setting{{"wind_model", "sines"}, {"wind_strength", "0"}, {"wind_mean", "0"}}
                             : Setting{{"wind_strength", "0"}, {"wind_mean", "0"}};
    return {
        {"bending springs", {{"bend_stiffness", "0"}}, raw && p.bend_stiffness > 0},
        {"bending by D", {{"bending_warp", "0"}, {"bending_weft", "0"}, {"bending_bias", "0"}}, bends(p)},
        {"shear", {{raw ? "shear_stiffness" : "shear_modulus", "0"}}, (raw ? p.shear_stiffness : p.shear_modulus) > 0},
        {"wind", calm, blows},
        {"gusts", {{"gust_speed", "0"}}, p.wind_model == WindModel::aero && p.gust_speed > 0},
        {"damping", {{"damping", "0"}}, p.damping > 0},
        {"self-collision", {{"collision", "none"}}, meets},
        {"its level", {{"collision", below()}, {"culling", "sound"}}, p.collision > CollisionLevel::spheres},
        {"friction", {{"friction", "0"}, {"static_friction", "0"}}, p.friction > 0},
        {"half of the vertices along a side", {{"resolution", std::to_string(side / 2)}}, side >= 10}};
}

// Both runs as far as both went; on other meshes only the centre is compared.
double change_of(const Trajectory& run, const Trajectory& whole, int horizon, double size_m)
{
    const double centre = glm::length(mean_centre(run) - mean_centre(whole));
    const int frames = std::min({horizon, run.frames(), whole.frames()});
    const bool one_mesh = run.positions[0].size() == whole.positions[0].size();
    const double positions = one_mesh && frames > 0 ? error_against(run, whole, frames).rms_m : 0;
    return std::max(positions, centre) / size_m;
}

}  // namespace

Explanation explain_scene(SceneStudy& study, double tolerance_share, const SweepProgress& progress)
{
    const SimParams& asked = study.asked_params();
    const ClothModel model = build_cloth_model(make_sheets(study.scene(), asked), asked.mass_lumping);
    const std::vector<Part> parts = parts_of(asked, model);
    Explanation explanation{study.name(), tolerance_share, 0, 0, 0, {}, {}};
    for (const Part& part : parts)
        if (!part.is_there && part.without.front().first != "resolution") explanation.absent.push_back(part.name);
    // All run as long as the whole does: else means would be those of other times.
    const Trajectory whole = run_trajectory(study.scene(), asked, long_frames(study), {.enough_ms = kEnoughMs});
    if (!whole.failure.empty()) throw Error(whole.failure, ExitCode::went_bad);
    explanation.ms_per_frame = whole.median_ms();
    explanation.intersections = count_intersections(study.scene(), asked, whole, kCheckEvery).per_pose();
    explanation.strain = whole.largest_strain;
    const int horizon = study.scene_class().frames;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!parts[i].is_there) continue;
        if (!progress(i, parts.size())) break;
        LeftOut& out = explanation.parts.emplace_back();
        out.part = parts[i].name;
        out.set = parts[i].without;
        const SimParams params = with_setting(asked, out.set);
        const Trajectory run = run_trajectory(study.scene(), params, whole.frames());
        out.failure = run.failure;
        if (run.frames() < whole.frames()) continue;
        out.change_share = change_of(run, whole, horizon, study.scene_class().size_m);
        out.ms_per_frame = run.median_ms();
        out.intersections = count_intersections(study.scene(), params, run, kCheckEvery).per_pose();
        out.strain = run.largest_strain;
        out.is_needed = out.change_share > tolerance_share || out.intersections > explanation.intersections;
    }
    return explanation;
}

std::string explain_table(const Explanation& e)
{
    std::string table =
        fmt::format("{}: {:.3g} ms a frame with everything, {:.3g} intersections a pose, largest strain {:.2g} %\n",
                    e.scene, e.ms_per_frame, e.intersections, 100 * e.strain);
    table += fmt::format("{:34} {:>9} {:>9} {:>7} {:>12} {:>8}  {}\n", "without", "changes", "ms", "saves",
                         "intersects", "strain", "so");
    for (const LeftOut& out : e.parts) {
        if (!out.failure.empty()) {
            table += fmt::format("{:34} needed: {}\n", out.part, out.failure);
            continue;
        }
        const double saved = 1 - out.ms_per_frame / e.ms_per_frame;
        table += fmt::format("{:34} {:>8.2g}% {:>9.3g} {:>6.0f}% {:>12.3g} {:>7.2g}%  {}\n", out.part,
                             100 * out.change_share, out.ms_per_frame, 100 * saved, out.intersections, 100 * out.strain,
                             out.is_needed      ? "needed"
                             : saved < kWorthIt ? "may stay: costs next to nothing"
                                                : "can go: " + setting_text(out.set, "--set "));
    }
    if (!e.absent.empty()) {
        table += "not in the scene, and no work:";
        for (const std::string& name : e.absent) table += (name == e.absent.front() ? " " : ", ") + name;
        table += "\n";
    }
    return table;
}

Json explain_json(const Explanation& e)
{
    Json parts = Json::array();
    for (const LeftOut& out : e.parts) {
        parts.push_back({{"part", out.part},
                         {"set", setting_json(out.set)},
                         {"change_share", out.change_share},
                         {"ms_per_frame", out.ms_per_frame},
                         {"intersections_per_pose", out.intersections},
                         {"largest_strain", out.strain},
                         {"failure", out.failure},
                         {"needed", out.is_needed}});
    }
    return {{"scene", e.scene},
            {"tolerance_share", e.tolerance_share},
            {"ms_per_frame", e.ms_per_frame},
            {"intersections_per_pose", e.intersections},
            {"largest_strain", e.strain},
            {"parts", parts},
            {"absent", e.absent}};
}

}  // namespace nuno
