// `nuno auto`.
#include "app/auto_command.h"

#include <fmt/format.h>

#include <cstdlib>

#include "app/interrupt.h"
#include "app/machine.h"
#include "app/sweep_flags.h"
#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "study/auto_choice.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kNothingRan = ": no setting that was tried ran to its end";
constexpr const char* kNotKept = ": the promise cannot be kept: of all that was tried this is the nearest";

fs::path cache_directory()
{
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != 0) return fs::path(cache) / "nuno";
    const char* home = std::getenv("HOME");
    return (home != nullptr && *home != 0 ? fs::path(home) : fs::temp_directory_path()) / ".cache/nuno";
}

// All that errors and costs depend on.
Json header_of(const SceneRun& run, const SceneStudy& study)
{
    const int threads = ThreadPool(run.params.threads).thread_count();
    return {{"study", "auto"},
            {"version", fmt::format("{} ({})", kVersion, kCommit)},
            {"machine", {{"cpu", cpu_name()}, {"threads", threads}}},
            {"scene", read_text(run.scene.path)},
            {"params", params_json(sim_param_table(), &study.asked_params())}};
}

std::string named(const Json& header)
{
    return fmt::format("{:016x}", std::hash<std::string>{}(header["scene"].dump() + header["params"].dump()));
}

void refuse_chosen(const CommonFlags& flags)
{
    refuse_set(flags, {"method", "substeps", "iterations", "tethers", "backend"},
               "it is chosen for the error or budget");
}

// Measures and chooses; what was measured before on this machine is remembered. `forget`: measures all anew.
AutoChoice choose_for(const SceneRun& run, const AutoGoal& goal, bool quiet, bool forget)
{
    SceneStudy study(run.scene, run.params);
    const Json header = header_of(run, study);
    const fs::path directory = cache_directory() / "auto" / named(header);
    std::error_code status;
    if (fs::exists(directory / "points.jsonl", status)) {
        const bool is_stale = forget || read_points(directory).header != header;
        if (is_stale && !forget && !quiet)
            fmt::print(stderr, "auto: what is remembered is of another machine or version; measured anew\n");
        if (is_stale) fs::remove(directory / "points.jsonl", status);
    }
    PointStore store(directory, header);
    AutoChoice choice = choose_setting(study, goal, store, InterruptibleProgress("auto", quiet));
    if (interrupted()) throw Error("auto: interrupted; what was measured is remembered", ExitCode::interrupted);
    return choice;
}

}  // namespace

void add_promise_flags(CLI::App& command, PromiseFlags& flags)
{
    command.add_option("--error", flags.error_percent, "Largest error, percent of the size of the cloth");
    command.add_option("--budget-ms", flags.budget_ms, "Largest cost of a frame, milliseconds");
}

bool apply_promise(const PromiseFlags& flags, const CommonFlags& common, SceneRun& run, std::optional<int> frames)
{
    if (!flags.is_given()) return true;
    refuse_chosen(common);
    const bool quiet = common.quiet;
    AutoChoice choice = choose_for(run, auto_goal(flags.error_percent, flags.budget_ms), quiet, false);
    if (!frames || *frames - 1 > choice.frames_looked_at)
        std::erase_if(choice.set, [](const auto& word) { return word.first == "collision"; });
    if (choice.set.empty()) throw Error(run.scene.name + kNothingRan, ExitCode::went_bad);
    run.params = with_setting(run.params, choice.set);
    run.check_applies = false;
    if (!quiet) fmt::print(stderr, "{}: {}\n", run.scene.name, setting_text(choice.set, "--set "));
    if (!quiet)
        for (const std::string& sentence : choice.given_up)
            fmt::print(stderr, "{}: given up: {}\n", run.scene.name, sentence);
    if (!choice.is_kept) fmt::print(stderr, "nuno: {}{}\n", run.scene.name, kNotKept);
    return choice.is_kept;
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
    const AutoChoice choice = choose_for(run, goal, flags.common.quiet, flags.forget);
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
                          {"given_up", choice.given_up}};
        write_whole(flags.common.json, report.dump(1) + "\n");
    }
    return static_cast<int>(choice.is_kept ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
