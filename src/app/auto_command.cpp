// `nuno auto`.
#include "app/auto_command.h"

#include <fmt/format.h>

#include "app/auto_ladder.h"
#include "app/auto_memory.h"
#include "app/interrupt.h"
#include "app/sweep_flags.h"
#include "core/error.h"
#include "core/files.h"
#include "study/auto_choice.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNothingRan = ": no setting that was tried ran to its end";
constexpr const char* kNotKept = ": the promise cannot be kept: of all that was tried this is the nearest";

void refuse_chosen(const CommonFlags& flags)
{
    refuse_set(flags, {"method", "substeps", "iterations", "tethers", "backend"},
               "it is chosen for the error or budget");
}

// Measures and chooses; what was measured before on this machine is remembered. `forget`: measures all anew. `ladder`,
// where not null, gets what a run can move on.
AutoChoice choose_for(const SceneRun& run, const AutoGoal& goal, bool quiet, bool forget, MeasuredLadder* ladder)
{
    const auto leave = [] {
        if (interrupted()) throw Error("auto: interrupted; what was measured is remembered", ExitCode::interrupted);
    };
    const SweepProgress progress = InterruptibleProgress("auto", quiet);
    SceneStudy study(run.scene, run.params, leave);
    PointStore store(memory_directory(study), memory_header(study),
                     forget ? FormerPoints::drop : FormerPoints::keep_own);
    if (store.dropped_others() && !quiet)
        fmt::print(stderr, "auto: what is remembered is of another program, mesh or machine; measured anew\n");
    AutoChoice choice = choose_setting(study, goal, store, progress);
    if (ladder != nullptr) *ladder = measure_ladder(study, run.params, goal, choice, store, progress);
    leave();
    return choice;
}

}  // namespace

void add_promise_flags(CLI::App& command, PromiseFlags& flags)
{
    command.add_option("--error", flags.error_percent, "Largest error, percent of the size of the cloth");
    command.add_option("--budget-ms", flags.budget_ms, "Largest cost of a frame, milliseconds");
}

std::optional<AutoGoal> promised_goal(const PromiseFlags& flags, const CommonFlags& common)
{
    if (!flags.is_given()) return std::nullopt;
    refuse_chosen(common);
    return auto_goal(flags.error_percent, flags.budget_ms);
}

std::shared_ptr<PromiseKeeper> apply_promise(const PromiseFlags& flags, const CommonFlags& common, SceneRun& run,
                                             int frames)
{
    const std::optional<AutoGoal> goal = promised_goal(flags, common);
    if (!goal) return nullptr;
    const bool quiet = common.quiet;
    MeasuredLadder ladder;
    AutoChoice choice = choose_for(run, *goal, quiet, false, &ladder);
    if (frames - 1 > choice.frames_looked_at)
        std::erase_if(choice.set, [](const auto& word) { return word.first == "collision"; });
    if (choice.set.empty()) throw Error(run.scene.name + kNothingRan, ExitCode::went_bad);
    run.params = with_setting(run.params, choice.set);
    run.check_applies = false;
    if (!quiet) fmt::print(stderr, "{}: {}\n", run.scene.name, setting_text(choice.set, "--set "));
    if (!quiet)
        for (const std::string& sentence : choice.given_up)
            fmt::print(stderr, "{}: given up: {}\n", run.scene.name, sentence);
    if (!choice.is_kept) fmt::print(stderr, "nuno: {}{}\n", run.scene.name, kNotKept);
    return std::make_shared<PromiseKeeper>(ladder.keeper());
}

void add_auto_flags(CLI::App& command, AutoFlags& flags)
{
    command.add_option("scene", flags.common.scene, "Scene")->capture_default_str();
    add_common_flags(command, flags.common);
    add_promise_flags(command, flags.promise);
    command.add_flag("--forget", flags.forget, "Measure anew what is remembered");
}

int run_auto(const AutoFlags& flags)
{
    const AutoGoal goal = auto_goal(flags.promise.error_percent, flags.promise.budget_ms);
    refuse_chosen(flags.common);
    const SceneRun run = prepare_run(flags.common, flags.common.scene);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    const AutoChoice choice = choose_for(run, goal, flags.common.quiet, flags.forget, nullptr);
    if (choice.set.empty()) throw Error(run.scene.name + kNothingRan, ExitCode::went_bad);
    fmt::print("{}\n", setting_text(choice.set, "--set "));
    fmt::print("error {:.2g} % of the size of the cloth, {:.3g} ms a frame; {} settings measured, {} remembered\n",
               100 * choice.error_share, choice.ms_per_frame, choice.tried, choice.known);
    for (const std::string& sentence : choice.given_up) fmt::print("given up: {}\n", sentence);
    if (!choice.is_kept) fmt::print("nuno: {}{}\n", run.scene.name, kNotKept);
    if (!flags.common.json.empty()) {
        const Json report{{"scene", run.scene.name},
                          {"set", setting_json(choice.set)},
                          {"error_share", choice.error_share},
                          {"ms_per_frame", choice.ms_per_frame},
                          {"kept", choice.is_kept},
                          {"frames_looked_at", choice.frames_looked_at},
                          {"horizon",
                           {{"frames", choice.horizon.frames},
                            {"size_m", choice.horizon.size_m},
                            {"collision", choice_names(CollisionLevel{})[std::size_t(choice.horizon_level)]}}},
                          {"given_up", choice.given_up}};
        write_whole(flags.common.json, report.dump(1) + "\n");
    }
    return static_cast<int>(choice.is_kept ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
