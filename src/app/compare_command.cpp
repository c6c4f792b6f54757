// `nuno compare`.
#include "app/compare_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/interrupt.h"
#include "app/machine.h"
#include "app/progress.h"
#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "sim/start_check.h"
#include "study/compare.h"
#include "study/compare_plot.h"

namespace nuno {
namespace {

// Where layers cross or touch at the start of a scene, in its own size.
void remark_on_start(const Scene& scene, const SimParams& params)
{
    const ClothModel model = build_cloth_model(make_sheets(scene, params), params.mass_lumping);
    ClothState state = start_state(model, params);
    ThreadPool pool(params.threads);
    for (const std::string& line : start_remarks(check_start(model, params, state.positions, pool), params))
        fmt::print(stderr, "{}: {}\n", scene.name, line);
}

}  // namespace

void add_compare_flags(CLI::App& command, CompareFlags& flags)
{
    command.add_option("scenes", flags.scenes, "Scenes; none: all of `nuno scenes`");
    add_common_flags(command, flags.common);
    command.add_option("--out", flags.out, "Directory for compare.json and the picture")->capture_default_str();
}

int run_compare(const CompareFlags& flags)
{
    std::vector<std::pair<Scene, SimParams>> runs;
    for (const std::string& name : flags.scenes.empty() ? scene_names() : flags.scenes) {
        SceneRun run = prepare_run(flags.common, name);
        if (!flags.common.quiet) remark_on_start(run.scene, run.params);
        runs.emplace_back(std::move(run.scene), run.params);
    }
    const std::filesystem::path out = flags.out;
    make_writable_directory(out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    const Machine machine(true);
    watch_interrupts();
    std::optional<Progress> progress;
    const std::vector<ComparePoint> points =
        compare_backends(runs, kComparedSizes, [&](int done, int total, const std::string&) {
            if (!progress) progress.emplace("compare", total, flags.common.quiet);
            progress->show(done);
            return !interrupted();
        });
    progress.reset();

    const bool software = machine.gl()->software;
    fmt::print("{}", compare_table(points, software));
    for (const ComparePoint& point : points)
        if (!point.failure.empty()) fmt::print(stderr, "nuno: {}\n", point.failure);
    const MachineInfo info = machine.info(ThreadPool(runs.front().second.threads).thread_count());
    const nlohmann::ordered_json json = {{"program", {{"name", "nuno"}, {"version", kVersion}, {"commit", kCommit}}},
                                         {"machine", machine_json(info)},
                                         {"points", compare_json(points)}};
    write_whole(out / "compare.json", json.dump(1) + "\n");
    if (!flags.common.json.empty()) write_whole(flags.common.json, json.dump(1) + "\n");
    if (!plot_comparison(points, software, out))
        fmt::print(stderr, "compare: no picture, since gnuplot is missing or failed; {} holds its data\n",
                   (out / "compare.dat").string());
    machine.check_gl();
    if (interrupted()) return static_cast<int>(ExitCode::interrupted);
    return static_cast<int>(backends_agree(points, software) ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
