// `nuno render`.
#include "app/render_command.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/frame_output.h"
#include "app/interrupt.h"
#include "app/machine.h"
#include "app/progress.h"
#include "core/error.h"
#include "core/files.h"
#include "model/mesh_remarks.h"
#include "sim/pose_check.h"
#include "sim/run_recorder.h"
#include "sim/saved_scene.h"
#include "sim/start_check.h"

namespace nuno {
namespace {

OutputPlan plan_output(const RenderFlags& flags)
{
    OutputPlan plan;
    plan.directory = flags.out;
    plan.images = !flags.no_images && (flags.video.empty() || !flags.out.empty());
    plan.video = flags.video;
    const MeshFormat format = flags.mesh == "obj"   ? MeshFormat::obj
                              : flags.mesh == "ply" ? MeshFormat::ply
                                                    : MeshFormat::none;
    plan.mesh = {flags.out, format, flags.pc2, flags.gltf};
    plan.every = flags.every;
    const bool needs_directory = plan.images || format != MeshFormat::none;
    if (needs_directory && flags.out.empty())
        throw Error("--out: is missing; name the directory that the frames go to");
    if (needs_directory) make_writable_directory(plan.directory);
    for (const std::string& file : {flags.common.json, flags.csv, flags.pc2, flags.gltf, flags.video})
        if (!file.empty()) check_can_write(file);
    if (!flags.save.empty()) check_can_save_scene(flags.save);
    const auto wants_ending = [](const char* flag, const std::string& file, const char* ending) {
        if (!file.empty() && std::filesystem::path(file).extension() != ending)
            throw Error(
                fmt::format("{} {}: is written in one format; give a name that ends in {}", flag, file, ending));
    };
    wants_ending("--pc2", flags.pc2, ".pc2");
    wants_ending("--gltf", flags.gltf, ".glb");
    return plan;
}

// Whether the scene's check holds; says so on stderr. 1 where it does not.
ExitCode report_check(const SceneRun& run, const RunMetrics& metrics, bool quiet)
{
    const std::vector<std::string> failures = failed_bounds(run.scene.check, metrics);
    for (const std::string& failure : failures) fmt::print(stderr, "nuno: end check failed: {}\n", failure);
    if (failures.empty() && !quiet) {
        const std::string through =
            run.params.count_pass_through ? fmt::format(", {} passed through", metrics.passed_through) : std::string();
        fmt::print(stderr, "{}: end check holds ({} contacts{})\n", run.scene.name, metrics.contacts, through);
    }
    return failures.empty() ? ExitCode::done : ExitCode::check_failed;
}

// Why the end check of a scene that has one does not apply; empty where it does.
std::string why_unchecked(const RenderFlags& flags, const SceneRun& run)
{
    if (!run.check_applies) return "a flag changed what it was written for";
    if (flags.frames < run.scene.check.frames) return fmt::format("it applies at frame {}", run.scene.check.frames);
    return {};
}

struct RunResult
{
    ExitCode code = ExitCode::done;
    RunRecorder recorder;
    std::optional<Error> failed;       // with what came before it recorded
    std::unique_ptr<PoseCheck> check;  // where asked for
    std::shared_ptr<PromiseKeeper> promise;
    std::uint64_t touching = 0;    // pairs of layers that touched as a pass began, in all frames
    std::uint64_t unresolved = 0;  // pairs of layers that the level of collision let through, in all frames
    int first_unresolved = 0;      // the first frame with one
    int held_back_frames = 0;      // in which vertices on handles went back with layers
    int first_held_back = 0;
};

// Why a run at `guaranteed` did not keep its promise; empty where it did.
std::vector<std::string> broken_promises(const StartCheck& start, const RunResult& result, bool one_pass)
{
    std::vector<std::string> reasons;
    if (start.tangled.crossing > 0)
        reasons.push_back(
            fmt::format("{} pairs of faces crossed at the start, the first where {}; take them apart in "
                        "the scene or with --untangle",
                        start.tangled.crossing, start.places.front()));
    if (start.tangled.touching + result.touching > 0)
        reasons.push_back(
            fmt::format("layers touched, {} pairs at the start and {} as passes began, and what touches is "
                        "let be; move the layers apart, and merge vertices that lie in one place",
                        start.tangled.touching, result.touching));
    if (result.unresolved > 0)
        reasons.push_back(fmt::format("layers passed through one another, {} times, first in frame {}",
                                      result.unresolved, result.first_unresolved));
    if (result.check) {
        const CheckCounts& found = result.check->counts();
        // On the way of a frame with several passes nothing was promised.
        if (found.intersections() > 0 || (found.passed_through > 0 && one_pass))
            reasons.push_back(fmt::format("the check found {}, first in frame {}", findings_text(found, one_pass),
                                          found.first_frame));
    }
    return reasons;
}

// 1 where the run did not keep what its level of collision promises; says so on stderr.
ExitCode report_promise(const SceneRun& run, const StartCheck& start, const RunResult& result, bool quiet)
{
    const bool one_pass = run.params.collision_passes == 1;
    if (result.check && !quiet)
        fmt::print(stderr, "{}: check of {} poses: {}\n", run.scene.name, result.check->counts().poses,
                   findings_text(result.check->counts(), one_pass));
    if (result.held_back_frames > 0 && !quiet)
        fmt::print(stderr,
                   "{}: in {} frames, first in frame {}, layers left handles no room for their motion: they lag\n",
                   run.scene.name, result.held_back_frames, result.first_held_back);
    if (run.params.collision != CollisionLevel::guaranteed) return ExitCode::done;
    const std::vector<std::string> reasons = broken_promises(start, result, one_pass);
    for (const std::string& reason : reasons)
        fmt::print(stderr, "nuno: {}: `guaranteed` does not hold: {}\n", run.scene.name, reason);
    return reasons.empty() ? ExitCode::done : ExitCode::check_failed;
}

// Goes on with another setting where a promise asks for it, and says so.
void keep_promise(const RenderFlags& flags, const SceneRun& run, const FrameStats& stats, Simulation& simulation,
                  RunResult& result)
{
    if (!result.promise) return;
    for (const std::string& line : result.promise->look(simulation, stats))
        if (!flags.common.quiet) fmt::print(stderr, "{}: {}\n", run.scene.name, line);
}

// Simulates and writes one frame.
void run_frame(const RenderFlags& flags, const SceneRun& run, int frame, Simulation& simulation, FrameOutput& output,
               RunResult& result)
{
    FrameStats stats;
    if (frame > 0) {
        stats = simulation.advance_frame();
        keep_promise(flags, run, stats, simulation, result);
    }
    if (stats.count.unresolved > 0 && result.unresolved == 0) result.first_unresolved = frame;
    result.unresolved += stats.count.unresolved;
    result.touching += stats.count.touching;
    if (stats.count.held_back > 0 && result.held_back_frames++ == 0) result.first_held_back = frame;
    if (result.check && result.check->wants(frame))
        for (const std::string& line : result.check->look(frame, simulation.state().positions))
            fmt::print(stderr, "{}: {}\n", run.scene.name, line);
    if (frame % flags.every == 0) output.write(simulation, stats.stage_ms);
    if (!flags.common.json.empty() || !flags.csv.empty() || (run.check_applies && run.scene.check.frames > 0))
        result.recorder.add(stats, simulation.diagnostics());
    if (run.check_applies && frame + 1 == run.scene.check.frames)
        result.code = report_check(run, result.recorder.metrics(), flags.common.quiet);
}

// Runs what may fail, and keeps the first error of all.
template <class Action>
void attempt(std::optional<Error>& failed, Action action)
{
    try {
        action();
    } catch (const Error& error) {
        if (!failed) failed = error;
    }
}

// Frame after frame; ends early, with all files whole, when interrupted, when the simulation goes bad or when a file
// cannot be written.
RunResult run_frames(const RenderFlags& flags, const SceneRun& run, Simulation& simulation, FrameOutput& output,
                     std::shared_ptr<PromiseKeeper> promise)
{
    RunResult result;
    result.promise = std::move(promise);
    if (flags.check > 0)
        result.check = std::make_unique<PoseCheck>(simulation.model(), flags.check, simulation.thread_count());
    Progress progress(run.scene.name, flags.frames, flags.common.quiet);
    for (int frame = 0; frame < flags.frames; ++frame) {
        if (interrupted()) {
            result.code = ExitCode::interrupted;
            break;
        }
        attempt(result.failed, [&] { run_frame(flags, run, frame, simulation, output, result); });
        if (result.failed) break;
        progress.show(frame + 1);
    }
    attempt(result.failed, [&] { output.finish(); });
    if (result.check) result.recorder.check = result.check->counts();
    if (result.code != ExitCode::interrupted) {
        const ExitCode collision = report_promise(run, simulation.start_check(), result, flags.common.quiet);
        if (collision != ExitCode::done) result.code = collision;
    }
    return result;
}

// What the user should know before a long run.
void remark(const RenderFlags& flags, const SceneRun& run, const Machine& machine, const Simulation& simulation)
{
    if (flags.common.quiet) return;
    machine.remark_on_backend(simulation);
    if (const auto warning = simulation.stability_warning()) fmt::print(stderr, "{}: {}\n", run.scene.name, *warning);
    for (const std::string& line : mesh_remarks(simulation.model()))
        fmt::print(stderr, "{}: {}\n", run.scene.name, line);
    for (const std::string& line : start_remarks(simulation.start_check(), run.params))
        fmt::print(stderr, "{}: {}\n", run.scene.name, line);
    const std::string reason = why_unchecked(flags, run);
    if (run.scene.check.frames > 0 && !reason.empty())
        fmt::print(stderr, "{}: the end check is left out; {}\n", run.scene.name, reason);
}

void write_report(const RenderFlags& flags, const SceneRun& run, const Machine& machine, Simulation& simulation,
                  const RunResult& result)
{
    if (flags.common.json.empty()) return;
    const auto view = params_json(view_param_table(), &run.view);
    auto report = make_report(result.recorder, simulation, machine.info(simulation.thread_count()), view);
    if (result.promise) report["promise"] = result.promise->report();
    write_whole(flags.common.json, report.dump(1) + "\n");
}

}  // namespace

void add_render_flags(CLI::App& command, RenderFlags& flags)
{
    command.add_option("scene", flags.common.scene, "A scene of `nuno scenes`, or the path of a .toml file")
        ->capture_default_str();
    add_common_flags(command, flags.common);
    command.add_option("--frames", flags.frames, "Number of frames; frame 0 is the start")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000000));
    command.add_option("--out", flags.out, "Directory for frame_00000.png, mesh_00000.obj, ...");
    command.add_option("--mesh", flags.mesh, "Write meshes too")->check(CLI::IsMember({"obj", "ply", "none"}));
    command.add_option("--pc2", flags.pc2,
                       "Write a PC2 point cache of the frames to FILE, ending .pc2, and its mesh beside it");
    command.add_option("--gltf", flags.gltf, "Write the cloth in motion to FILE, binary glTF 2.0, ending .glb");
    command.add_option("--csv", flags.csv, "Write times, counts and energies of every frame to FILE");
    command.add_option("--save", flags.save, "Write a scene to FILE that goes on from the last frame, ending .toml");
    command.add_option("--video", flags.video, "Write a video to FILE, such as cloth.mp4; needs ffmpeg");
    command.add_option("--every", flags.every, "Write every K-th frame")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000000));
    command.add_option("--check", flags.check, "Look for intersections in every N-th frame")
        ->check(CLI::Range(1, 100000000));
    command.add_option("--size", flags.size, "Size of the pictures, WxH");
    command.add_flag("--no-images", flags.no_images, "Write no pictures");
    add_promise_flags(command, flags.promise);
}

int run_render(const RenderFlags& flags)
{
    SceneRun run = prepare_run(flags.common, flags.common.scene);
    apply_size(flags.size, run.view);
    const OutputPlan plan = plan_output(flags);
    const std::shared_ptr<PromiseKeeper> promise = apply_promise(flags.promise, flags.common, run, flags.frames);
    const Machine machine(plan.draws() || run.params.backend == Backend::gpu);
    Simulation simulation(run.scene, run.params);
    remark(flags, run, machine, simulation);
    FrameOutput output(plan, simulation, run.view);
    watch_interrupts();
    RunResult result = run_frames(flags, run, simulation, output, promise);
    attempt(result.failed, [&] { write_report(flags, run, machine, simulation, result); });
    attempt(result.failed, [&] {
        if (!flags.csv.empty()) write_whole(flags.csv, frames_csv(result.recorder));
    });
    if (!flags.save.empty() && !result.failed)
        attempt(result.failed, [&] { save_scene(flags.save, simulation, view_settings(run.view)); });
    machine.check_gl();
    if (result.failed) throw *result.failed;
    if (const auto warning = flags.common.quiet ? std::nullopt : simulation.present_warning())
        fmt::print(stderr, "{}: {}\n", run.scene.name, *warning);
    if (flags.common.hash) fmt::print("state-hash {}\n", hash_text(simulation.state()));
    const bool kept = !promise || promise->is_kept();
    if (!kept) fmt::print(stderr, "nuno: {}: {}\n", run.scene.name, promise->verdict());
    return static_cast<int>(kept || result.code != ExitCode::done ? result.code : ExitCode::check_failed);
}

}  // namespace nuno
