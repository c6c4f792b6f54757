// What is measured at each point of the trade.
#include "study/trade_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "sim/run_recorder.h"
#include "study/grid_poses.h"
#include "study/run_measures.h"
#include "study/setting.h"
#include "study/trade_settings.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Frames between those in which faces that intersect are counted.
constexpr int kCheckEvery = 4;

double seconds(int frames, const SimParams& params) { return double(frames) / params.frame_rate; }

Json measure_time(SceneStudy& study, const Setting& setting, const TradeOptions& options)
{
    const SceneClass& scene_class = study.scene_class();
    const SimParams params = with_setting(study.params(), setting);
    const int frames = scene_class.frames;
    const Trajectory run = run_trajectory(study.scene(), params, frames, {.most_ms = options.most_ms});
    Json result{{"set", setting_json(setting)}, {"substeps", run.substeps}};
    if (run.too_slow) result["too_slow"] = true;
    if (!run.failure.empty()) result["failure"] = run.failure;
    if (run.frames() < frames) return result;
    const TrajectoryError error = error_against(run, study.reference(), frames);
    const double ms = least_frames_ms(study.scene(), params, frames, options.repeats, options.repeats_ms);
    result["ms_per_second"] = ms / seconds(frames, params);
    result["error_share"] = error.rms_m / scene_class.size_m;
    result["rms_m"] = error.rms_m;
    result["largest_m"] = error.largest_m;
    result["energy_share"] = error.energy_share;
    result["largest_strain"] = run.largest_strain;
    result["reference_strain"] = study.reference().largest_strain;
    return result;
}

// How far a coarser mesh ends up from the mesh of the scene, both converged in time.
Json measure_space(SceneStudy& study, int resolution)
{
    SimParams params = study.params();
    params.resolution = resolution;
    const int frames = study.scene_class().frames;
    const Trajectory coarse = run_trajectory(study.scene(), reference_params(params), frames);
    Json result{{"set", setting_json({{"resolution", std::to_string(resolution)}})}};
    if (coarse.frames() < frames) return result["failure"] = coarse.failure, result;
    const double rms = rms_of_grids(make_sheets(study.scene(), params), coarse,
                                    make_sheets(study.scene(), study.params()), study.reference(), frames);
    result["rms_m"] = rms;
    result["error_share"] = rms / study.scene_class().size_m;
    return result;
}

Json measure_model(SceneStudy& study, const Setting& setting)
{
    const int frames = study.scene_class().frames;
    const Trajectory other =
        run_trajectory(study.scene(), reference_params(with_setting(study.params(), setting)), frames);
    Json result{{"set", setting_json(setting)}};
    if (other.frames() < frames) return result["failure"] = other.failure, result;
    const TrajectoryError error = error_against(other, study.reference(), frames);
    result["rms_m"] = error.rms_m;
    result["error_share"] = error.rms_m / study.scene_class().size_m;
    return result;
}

// With the settings of the scene, to its end.
Json measure_cost(SceneStudy& study, const Setting& setting, bool counts_crossings)
{
    const SimParams params = with_setting(study.asked_params(), setting);
    Json result{{"set", setting_json(setting)}};
    const int frames = counts_crossings ? long_frames(study) : std::min(long_frames(study), 60);
    const Trajectory run = run_trajectory(study.scene(), params, frames);
    if (!run.failure.empty()) return result["failure"] = run.failure, result;
    result["ms_per_frame"] = run.median_ms();
    result["frames"] = frames;
    result["largest_strain"] = run.largest_strain;
    if (!counts_crossings) return result;
    const Intersections found = count_intersections(study.scene(), params, run, kCheckEvery);
    result["poses_looked_at"] = found.poses;
    result["poses_that_intersect"] = found.poses_that_intersect;
    result["intersections_per_pose"] = found.per_pose();
    result["contacts"] = run.count.contacts;
    result["rollbacks"] = run.count.rollbacks;
    return result;
}

// Mean and standard deviation of what the runs of an ensemble measured.
struct Statistic
{
    std::vector<double> values;

    double mean() const
    {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / double(values.size());
    }
    double deviation() const
    {
        if (values.size() < 2) return 0;
        double sum = 0;
        for (const double value : values) sum += (value - mean()) * (value - mean());
        return std::sqrt(sum / double(values.size() - 1));
    }
};

// Of the second half of a run.
void add_statistics(const Trajectory& run, double size_m, std::vector<std::pair<std::string, Statistic>>& statistics)
{
    const glm::dvec3 centre = mean_centre(run) / size_m;
    const auto half = run.kinetic_j.begin() + run.frames() / 2;
    const double kinetic = std::accumulate(half, run.kinetic_j.end(), 0.0) / double(run.kinetic_j.end() - half);
    const double values[] = {centre.x, centre.y, centre.z, kinetic, run.largest_strain};
    for (std::size_t k = 0; k < statistics.size(); ++k) statistics[k].second.values.push_back(values[k]);
}

Json measure_long(SceneStudy& study, const Setting& setting, const TradeOptions& options)
{
    const SceneClass& scene_class = study.scene_class();
    const int frames = long_frames(study), runs = scene_class.is_chaotic ? options.ensemble : 1;
    std::vector<std::pair<std::string, Statistic>> statistics{{"centre_x_share", {}},
                                                              {"centre_y_share", {}},
                                                              {"centre_z_share", {}},
                                                              {"kinetic_j", {}},
                                                              {"largest_strain", {}}};
    Json result{{"set", setting_json(setting)}, {"frames", frames}, {"runs", runs}};
    double ms = 0, at_rest = 0;
    for (int number = 0; number < runs; ++number) {
        SimParams params = with_setting(study.asked_params(), setting);
        params.seed += number;
        const Trajectory run = run_trajectory(study.scene(), params, frames, {.most_ms = options.most_ms});
        if (run.too_slow) return result["too_slow"] = true, result;
        if (!run.failure.empty()) return result["failure"] = run.failure, result;
        result["substeps"] = run.substeps;
        ms += run.ms();
        at_rest = run.kinetic_j.back() / std::max(1e-30, *std::max_element(run.kinetic_j.begin(), run.kinetic_j.end()));
        add_statistics(run, scene_class.size_m, statistics);
    }
    result["ms_per_second"] = ms / runs / seconds(frames, study.asked_params());
    result["kinetic_share_at_the_end"] = at_rest;
    for (const auto& [name, statistic] : statistics)
        result[name] = {{"mean", statistic.mean()}, {"deviation", statistic.deviation()}};
    return result;
}

int longest_side(const std::vector<SheetSource>& sheets)
{
    int side = 0;
    for (const SheetSource& sheet : sheets) side = std::max({side, sheet.columns, sheet.rows});
    return side;
}

std::vector<Setting> other_models(const SimParams& params)
{
    std::vector<Setting> settings;
    if (params.fabric == Fabric::custom && params.internal_model == InternalModel::springs) return settings;
    for (const auto model : {InternalModel::springs, InternalModel::fabric_springs, InternalModel::continuum})
        if (model != params.internal_model)
            settings.push_back({{"internal_model", std::string(choice_names(model)[std::size_t(model)])}});
    return settings;
}

std::vector<Setting> each(std::string name, const std::vector<std::string>& values)
{
    std::vector<Setting> settings;
    for (const std::string& value : values) settings.push_back({{name, value}});
    return settings;
}

// A run that goes bad, that of the reference included, is what was found at this point.
Json measured(const std::function<Json()>& measure, const Setting& setting)
{
    try {
        return measure();
    } catch (const Error& error) {
        if (error.code() != ExitCode::went_bad) throw;
        return {{"set", setting_json(setting)}, {"failure", error.what()}};
    }
}

}  // namespace

std::vector<SweepPoint> trade_points(SceneStudy& study, const TradeOptions& options)
{
    std::vector<SweepPoint> points;
    const auto add = [&](const std::string& kind, const Setting& setting, std::function<Json()> measure) {
        const std::string id =
            fmt::format("{}/{}{}{}", study.name(), kind, setting.empty() ? "" : "/", setting_text(setting));
        points.push_back({id, [measure = std::move(measure), setting] { return measured(measure, setting); }});
    };
    const SimParams asked = study.asked_params();
    const std::vector<SheetSource> sheets = make_sheets(study.scene(), asked);
    const ClothModel model = build_cloth_model(sheets, asked.mass_lumping);
    add("scene", {}, [&study] { return class_json(study.scene_class(), study.params()); });
    for (const Setting& setting : settings_in_time(model, study.scene().bodies, asked))
        add("time", setting, [&study, setting, options] { return measure_time(study, setting, options); });
    const int side = longest_side(sheets);
    for (const int resolution : {side / 2, side / 4})
        if (resolution >= 5)
            add("space", {{"resolution", std::to_string(resolution)}},
                [&study, resolution] { return measure_space(study, resolution); });
    for (const Setting& setting : other_models(asked))
        add("model", setting, [&study, setting] { return measure_model(study, setting); });
    std::vector<std::string> levels;
    for (const std::string_view level : choice_names(CollisionLevel{})) levels.emplace_back(level);
    for (const Setting& setting : each("collision", levels))
        add("level", setting, [&study, setting] {
            Setting sound = setting;
            sound.emplace_back("culling", "sound");
            return measure_cost(study, sound, true);
        });
    for (const Setting& setting : each("threads", {"1", "0"}))
        add("threads", setting, [&study, setting] { return measure_cost(study, setting, false); });
    for (const Setting& setting : each("backend", {"cpu", "gpu"}))
        if (options.with_gpu || setting[0].second == "cpu")
            add("backend", setting, [&study, setting] { return measure_cost(study, setting, false); });
    for (const Setting& setting : settings_by_method(model, study.scene().bodies, asked))
        add("long", setting, [&study, setting, options] { return measure_long(study, setting, options); });
    return points;
}

}  // namespace nuno
