// The choice of a setting, and its ladder.
#include "study/auto_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "study/auto_search.h"
#include "study/doubling_error.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// What is aimed at, of the goal: another start of the same scene is about so much off, and so are times.
constexpr double kAim = 0.9;
// What a run may have to go up to is looked for down to this share of the error asked for.
constexpr double kFinerShare = 0.2;
// Estimates that the mean of a setting is of.
constexpr int kDoublings = 8;

std::string_view level_name(CollisionLevel level) { return choice_names(CollisionLevel{})[std::size_t(level)]; }

// The scene's class, and whether layers come near each other at any time of its run.
Json describe(SceneStudy& study)
{
    Json about = class_json(study.scene_class(), study.params());
    SimParams probe = study.asked_params();
    about["meets"] =
        probe.collision != CollisionLevel::none && layers_meet(study.scene(), probe, long_frames(study), study.watch());
    return about;
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
            study.ask_watch();
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
    Search search(study, store, level, progress);
    const std::optional<Rung> rung = goal.error_share ? search.cheapest_within(kAim * *goal.error_share)
                                                      : search.most_exact_within(kAim * *goal.budget_ms);
    AutoChoice best;
    best.tried = search.tried();
    best.known = search.known();
    if (rung) {
        best.set = best.rung = rung->set;
        best.substeps = rung->substeps;
        best.error_share = rung->error_share;
        best.ms_per_frame = rung->ms_per_frame;
        best.is_kept = goal.is_kept_by(best.error_share, best.ms_per_frame);
    }
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
    Search search(study, store, level, progress);
    if (goal.error_share)
        search.cheapest_within(kFinerShare * *goal.error_share);
    else
        search.most_exact_within(kAim * *goal.budget_ms);
    const double most_ms = goal.budget_ms ? kForecastTrust * *goal.budget_ms : std::numeric_limits<double>::infinity();
    std::vector<Rung> ladder = frontier(search.rungs(most_ms, choice.rung), choice.rung);
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
