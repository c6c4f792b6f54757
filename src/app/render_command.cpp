// `nuno render`.
#include "app/render_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "app/frame_output.h"
#include "app/interrupt.h"
#include "app/machine.h"
#include "app/progress.h"
#include "core/error.h"
#include "core/files.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

OutputPlan plan_output(const RenderFlags& flags)
{
    OutputPlan plan;
    plan.directory = flags.out;
    plan.images = !flags.no_images && (flags.video.empty() || !flags.out.empty());
    plan.mesh = flags.mesh == "obj" ? MeshFormat::obj : flags.mesh == "ply" ? MeshFormat::ply : MeshFormat::none;
    plan.pc2 = flags.pc2;
    plan.video = flags.video;
    plan.every = flags.every;
    const bool needs_directory = plan.images || plan.mesh != MeshFormat::none;
    if (needs_directory && flags.out.empty())
        throw Error("--out: is missing; name the directory that the frames go to");
    if (needs_directory) make_writable_directory(plan.directory);
    return plan;
}

// Whether the scene's check holds; says so on stderr. 1 where it does not.
ExitCode report_check(const SceneRun& run, const RunMetrics& metrics, bool quiet)
{
    const std::vector<std::string> failures = failed_bounds(run.scene.check, metrics);
    for (const std::string& failure : failures) fmt::print(stderr, "nuno: end check failed: {}\n", failure);
    if (failures.empty() && !quiet)
        fmt::print(stderr, "{}: end check holds ({} contacts, {} passed through)\n", run.scene.name, metrics.contacts,
                   metrics.passed_through);
    return failures.empty() ? ExitCode::done : ExitCode::check_failed;
}

struct RunResult
{
    ExitCode code = ExitCode::done;
    RunRecorder recorder;
};

// Simulates and writes frame after frame; stops early, with all files whole, when interrupted.
RunResult run_frames(const RenderFlags& flags, const SceneRun& run, Simulation& simulation, FrameOutput& output)
{
    RunResult result;
    const bool measured = !flags.common.json.empty() || (run.check_applies && run.scene.check.frames > 0);
    Progress progress(run.scene.name, flags.frames, flags.common.quiet);
    for (int frame = 0; frame < flags.frames; ++frame) {
        if (interrupted()) {
            result.code = ExitCode::interrupted;
            break;
        }
        FrameStats stats;
        if (frame > 0) stats = simulation.advance_frame();
        if (frame % flags.every == 0) output.write(simulation, stats.stage_ms);
        if (measured) result.recorder.add(stats, simulation.diagnostics());
        if (run.check_applies && frame + 1 == run.scene.check.frames)
            result.code = report_check(run, result.recorder.metrics(), flags.common.quiet);
        progress.show(frame + 1);
    }
    output.finish();
    return result;
}

}  // namespace

void add_render_flags(CLI::App& command, RenderFlags& flags)
{
    command.add_option("scene", flags.common.scene, "A scene of `nuno scenes`, or the path of a .toml file");
    add_common_flags(command, flags.common);
    command.add_option("--frames", flags.frames, "Number of frames; frame 0 is the start")
        ->check(CLI::Range(1, 100000000));
    command.add_option("--out", flags.out, "Directory for frame_00000.png, mesh_00000.obj, ...");
    command.add_option("--mesh", flags.mesh, "Write meshes too")->check(CLI::IsMember({"obj", "ply", "none"}));
    command.add_option("--pc2", flags.pc2, "Write a PC2 point cache of the frames to FILE");
    command.add_option("--video", flags.video, "Write a video to FILE, such as cloth.mp4; needs ffmpeg");
    command.add_option("--every", flags.every, "Write every K-th frame")->check(CLI::Range(1, 100000000));
    command.add_option("--size", flags.size, "Size of the pictures, WxH");
    command.add_flag("--no-images", flags.no_images, "Write no pictures");
}

int run_render(const RenderFlags& flags)
{
    SceneRun run = prepare_run(flags.common, flags.common.scene);
    apply_size(flags.size, run.view);
    const OutputPlan plan = plan_output(flags);
    const Machine machine(plan.draws() || run.params.backend == Backend::gpu);
    Simulation simulation(run.scene, run.params);
    if (!flags.common.quiet) {
        machine.remark_on_backend(simulation);
        if (const auto warning = simulation.stability_warning()) fmt::print(stderr, "{}\n", *warning);
    }
    FrameOutput output(plan, simulation, run.view);
    watch_interrupts();
    const RunResult result = run_frames(flags, run, simulation, output);
    if (!flags.common.json.empty()) {
        const auto view = params_json(view_param_table(), &run.view);
        write_whole(
            flags.common.json,
            make_report(result.recorder, simulation, machine.info(simulation.thread_count()), view).dump(1) + "\n");
    }
    if (flags.common.hash) fmt::print("state-hash {}\n", hash_text(simulation.state()));
    return static_cast<int>(result.code);
}

}  // namespace nuno
