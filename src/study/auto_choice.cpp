// The search for a setting.
#include "study/auto_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/error.h"
#include "study/doubling_error.h"
#include "study/trade_settings.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Frames that tell what a setting costs at the start, and runs of them.
constexpr int kProbeFrames = 3, kProbeRuns = 3;
constexpr double kProbeMs = 200;
// A setting slower than this a simulated second is given up.
constexpr double kMostMs = 20000;
// How long the frames of a scene may take that tell what a setting costs later on [ms].
constexpr double kLongMs = 4000;
// A dearer start than this many times the best cost is not looked at: probes are a little uncertain.
constexpr double kProbeTrust = 1.3;
// What is aimed at, of the goal: another start of the same scene is about so much off, and so are times.
constexpr double kAim = 0.9;
// What a run may have to go up to is looked for down to this share of the error asked for; a rung of a ladder has at most
// this share of the error of the one before.
constexpr double kFinerShare = 0.2, kRungShare = 0.8;
// Estimates that the mean of a setting is of.
constexpr int kDoublings = 8;

struct Candidate
{
    Setting set;
    double probe_ms = 0;  // of a frame at the start, without self-collision; infinite where it goes bad
};

std::string_view level_name(CollisionLevel level) { return choice_names(CollisionLevel{})[std::size_t(level)]; }

// The result of a point, measured where the store lacks it.
const Json& stored(PointStore& store, const std::string& id, const std::function<Json()>& measure)
{
    if (!store.holds(id)) store.add(id, measure());
    return store.results().at(id);
}

// The scene's class, and whether layers come near each other at any time of its run.
Json describe(SceneStudy& study)
{
    Json about = class_json(study.scene_class(), study.params());
    SimParams probe = study.asked_params();
    about["meets"] = probe.collision != CollisionLevel::none && layers_meet(study.scene(), probe, long_frames(study));
    return about;
}

std::vector<Candidate> candidates_by_cost(SceneStudy& study, PointStore& store)
{
    const SimParams& asked = study.asked_params();
    SimParams bare = asked;
    bare.collision = CollisionLevel::none;
    const ClothModel model = build_cloth_model(make_sheets(study.scene(), asked), asked.mass_lumping);
    std::vector<Candidate> candidates;
    for (Setting& setting : settings_in_time(model, study.scene().bodies, asked)) {
        const Json& probe = stored(store, "probe/" + setting_text(setting), [&]() -> Json {
            try {
                const SimParams params = with_setting(bare, setting);
                return {
                    {"ms", least_frames_ms(study.scene(), params, kProbeFrames, kProbeRuns, kProbeMs) / kProbeFrames}};
            } catch (const Error& error) {
                if (error.code() != ExitCode::went_bad) throw;
                return {{"failure", error.what()}};
            }
        });
        if (probe.contains("ms")) candidates.push_back({std::move(setting), probe["ms"]});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.probe_ms < b.probe_ms; });
    return candidates;
}

// Error over the horizon; cost of a frame of the whole scene, with self-collision. Neither where the run did not get to
// its end.
Json measure(SceneStudy& study, const Setting& setting, CollisionLevel level)
{
    const int frames = study.scene_class().frames;
    const Trajectory run = run_trajectory(study.scene(), with_setting(study.params(), setting), frames, kMostMs);
    Json result{{"substeps", run.substeps}};
    if (run.frames() < frames) return result["failure"] = run.too_slow ? "too slow" : run.failure, result;
    SimParams whole = with_setting(study.asked_params(), setting);
    whole.collision = level;
    const Trajectory later = run_trajectory(study.scene(), whole, long_frames(study), {}, kLongMs);
    if (!later.failure.empty()) return result["failure"] = later.failure, result;
    result["error_share"] = error_against(run, study.reference(), frames).rms_m / study.scene_class().size_m;
    result["ms_per_frame"] = later.median_ms();
    result["largest_strain"] = later.largest_strain;
    return result;
}

// How far from the goal, for choosing among settings that do not keep it.
double excess(const AutoGoal& goal, double error_share, double ms)
{
    return goal.error_share ? error_share / *goal.error_share : ms / *goal.budget_ms;
}

bool is_better(const AutoGoal& goal, const AutoChoice& best, double error_share, double ms)
{
    if (best.rung.empty()) return true;
    const bool kept = goal.is_kept_by(error_share, ms);
    if (kept != best.is_kept) return kept;
    if (!kept) return excess(goal, error_share, ms) < excess(goal, best.error_share, best.ms_per_frame);
    return goal.error_share ? ms < best.ms_per_frame : error_share < best.error_share;
}

AutoGoal share_of(AutoGoal goal, double share)
{
    if (goal.error_share) *goal.error_share *= share;
    if (goal.budget_ms) *goal.budget_ms *= share;
    return goal;
}

// Looks for the best by rising cost until no cheaper one is left. All that ran to their end, on the way.
std::vector<Rung> search(SceneStudy& study, const AutoGoal& goal, CollisionLevel level, PointStore& store,
                         const SweepProgress& progress, AutoChoice& best)
{
    const std::vector<Candidate> candidates = candidates_by_cost(study, store);
    std::vector<Rung> seen;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        const double most = goal.budget_ms ? *goal.budget_ms : best.ms_per_frame;
        if ((goal.budget_ms || best.is_kept) && !best.rung.empty() && candidate.probe_ms > kProbeTrust * most) break;
        if (!progress(i, candidates.size())) break;
        const std::string id = setting_text(candidate.set);
        best.known += store.holds(id);
        best.tried += !store.holds(id);
        const Json& result = stored(store, id, [&] { return measure(study, candidate.set, level); });
        if (!result.contains("error_share")) continue;
        const double error = result["error_share"], ms = result["ms_per_frame"];
        seen.push_back({candidate.set, result["substeps"], error, ms, result["largest_strain"]});
        if (!is_better(goal, best, error, ms)) continue;
        best.rung = candidate.set;
        best.substeps = result["substeps"];
        best.error_share = error;
        best.ms_per_frame = ms;
        best.is_kept = goal.is_kept_by(error, ms);
    }
    return seen;
}

// Those that nothing is both cheaper and more exact than, each clearly more exact than the one before; `chosen` is kept.
std::vector<Rung> frontier(std::vector<Rung> seen, const Setting& chosen)
{
    std::stable_sort(seen.begin(), seen.end(),
                     [](const Rung& a, const Rung& b) { return a.ms_per_frame < b.ms_per_frame; });
    const auto own = std::find_if(seen.begin(), seen.end(), [&](const Rung& rung) { return rung.set == chosen; });
    const double error = own == seen.end() ? 0 : own->error_share;
    std::vector<Rung> ladder;
    for (const Rung& rung : seen) {
        const bool is_chosen = rung.set == chosen;
        const bool is_before = own != seen.end() && rung.ms_per_frame <= own->ms_per_frame;
        if (!is_chosen && is_before && rung.error_share <= error) continue;
        if (is_chosen || ladder.empty() || rung.error_share < kRungShare * ladder.back().error_share)
            ladder.push_back(rung);
    }
    return ladder;
}

// Over the horizon; null where it has no number.
Json mean_doubling_m(SceneStudy& study, const Setting& setting)
{
    const int frames = study.scene_class().frames, stride = std::max(1, frames / kDoublings);
    Simulation simulation(study.scene(), with_setting(study.params(), setting));
    ThreadPool pool(simulation.thread_count());
    double sum = 0;
    int count = 0;
    try {
        for (int frame = 1; frame < frames || count == 0; ++frame) {
            simulation.advance_frame();
            if (frame % stride != 0) continue;
            const double error = doubling_error_m(simulation, pool);
            sum += error * error;
            ++count;
        }
    } catch (const Error& error) {
        if (error.code() != ExitCode::went_bad) throw;
        return nullptr;
    }
    const double mean = std::sqrt(sum / count);
    return std::isfinite(mean) ? Json(mean) : Json(nullptr);
}

void say_what_is_given_up(const Json& about, const SimParams& asked, AutoChoice& choice)
{
    if (asked.collision != CollisionLevel::none && !about.at("meets").get<bool>())
        choice.given_up.push_back(
            fmt::format("self-collision, {} in the scene: its layers do not come near each "
                        "other",
                        level_name(asked.collision)));
    if (about.at("chaotic").get<bool>())
        choice.given_up.push_back(fmt::format(
            "any promise of positions after {:.2g} s: from then on rounding alone moves the cloth by {:g} % of its "
            "size",
            about.at("frames").get<double>() / asked.frame_rate, 100 * kMostDoubt));
    const auto has = [&](std::string_view name) {
        return std::any_of(choice.set.begin(), choice.set.end(), [&](const auto& word) { return word.first == name; });
    };
    const int passes = most_passes(asked);
    if (about.at("meets").get<bool>() && passes > choice.substeps && choice.substeps > 0)
        choice.given_up.push_back(fmt::format(
            "collision passes: up to {} a frame in the scene, {} with so many substeps", passes, choice.substeps));
    const bool sweeps = !choice.set.empty() && (choice.set[0].second == "xpbd" || choice.set[0].second == "vbd");
    if (sweeps && !has("tethers") && about.at("tethered").get<bool>())
        choice.given_up.push_back("stretch along the way to a pin: tethers forbid it");
}

}  // namespace

AutoGoal auto_goal(std::optional<double> error_percent, std::optional<double> budget_ms)
{
    if (error_percent.has_value() == budget_ms.has_value())
        throw Error("auto: give one of --error PERCENT and --budget-ms MS");
    if (error_percent && !(*error_percent > 0 && *error_percent <= 100))
        throw Error(
            fmt::format("--error {}: no setting has no error; give percent of the size of the cloth, over 0 and up "
                        "to 100, such as 1",
                        *error_percent));
    if (budget_ms && !(*budget_ms > 0 && *budget_ms < std::numeric_limits<double>::infinity()))
        throw Error(
            fmt::format("--budget-ms {}: no frame takes no time; give milliseconds over 0, such as 4", *budget_ms));
    AutoGoal goal;
    if (error_percent) goal.error_share = *error_percent / 100;
    goal.budget_ms = budget_ms;
    return goal;
}

AutoChoice choose_setting(SceneStudy& study, const AutoGoal& goal, PointStore& store, const SweepProgress& progress)
{
    const SimParams& asked = study.asked_params();
    const Json about = stored(store, "scene", [&] { return describe(study); });
    const CollisionLevel level = about.at("meets").get<bool>() ? asked.collision : CollisionLevel::none;
    AutoChoice best;
    search(study, share_of(goal, kAim), level, store, progress, best);
    best.is_kept = !best.rung.empty() && goal.is_kept_by(best.error_share, best.ms_per_frame);
    best.set = best.rung;
    if (level != asked.collision && !best.set.empty()) best.set.emplace_back("collision", level_name(level));
    if (!best.set.empty()) best.set.emplace_back("backend", "cpu");
    best.horizon = study.scene_class();
    best.horizon_level = study.params().collision;
    best.frames_looked_at = long_frames(study);
    say_what_is_given_up(about, asked, best);
    return best;
}

std::vector<Rung> ladder_around(SceneStudy& study, const AutoGoal& goal, const AutoChoice& choice, PointStore& store,
                                const SweepProgress& progress)
{
    if (choice.rung.empty()) return {};
    const bool meets = stored(store, "scene", [&] { return describe(study); }).at("meets");
    const CollisionLevel level = meets ? study.asked_params().collision : CollisionLevel::none;
    const AutoGoal finer = goal.error_share ? share_of(goal, kFinerShare) : goal;
    AutoChoice finest;
    std::vector<Rung> ladder = frontier(search(study, finer, level, store, progress, finest), choice.rung);
    if (!goal.error_share) return ladder;
    for (Rung& rung : ladder) {
        const Json& result = stored(store, "doubling/" + setting_text(rung.set), [&] {
            return Json{{"m", mean_doubling_m(study, rung.set)}};
        });
        rung.doubling_m = result.at("m").is_number() ? result["m"].get<double>() : 0;
    }
    // What has no estimate to compare with can only be stayed on.
    std::erase_if(ladder, [&](const Rung& rung) { return !(rung.doubling_m > 0) && rung.set != choice.rung; });
    return ladder;
}

}  // namespace nuno
