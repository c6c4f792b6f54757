// `nuno trade` and `nuno merge`.
#include "app/trade_command.h"

#include <fmt/format.h>

#include <deque>

#include "app/machine.h"
#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "study/trade_points.h"
#include "study/trade_report.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kScenes{"seed", "hang", "flag", "twist"};

// A context for the points of the gpu backend, where there is OpenGL.
std::unique_ptr<Machine> machine_with_gl(bool quiet)
{
    try {
        return std::make_unique<Machine>(true);
    } catch (const Error& error) {
        if (!quiet) fmt::print(stderr, "trade: no points of the gpu backend: {}\n", error.what());
        return std::make_unique<Machine>(false);
    }
}

// All that costs and errors depend on.
Json header_of(const std::deque<SceneStudy>& studies, const Machine& machine, const SimParams& params, int repeats)
{
    Json scenes;
    for (const SceneStudy& study : studies)
        scenes[study.name()] = {{"text", read_text(study.scene().path)},
                                {"params", params_json(sim_param_table(), &study.asked_params())}};
    Json about = machine_json(machine.info(ThreadPool(0).thread_count()));
    return {{"study", "trade"},   {"version", fmt::format("{} ({})", kVersion, kCommit)},
            {"machine", about},   {"threads", ThreadPool(params.threads).thread_count()},
            {"repeats", repeats}, {"scenes", scenes}};
}

// Tables, pictures and the page, from all points that are there.
void write_report(const std::map<std::string, Json>& results, const Json& header, const fs::path& out, bool quiet)
{
    const std::vector<TradeScene> scenes = trade_scenes(results);
    write_whole(out / "trade.csv", trade_csv(scenes));
    write_whole(out / "trade.json", Json{{"header", header}, {"scenes", trade_json(scenes)}}.dump(1) + "\n");
    bool drawn = true;
    for (const TradeScene& scene : scenes) drawn = plot_trade(scene, out) && drawn;
    if (!drawn && !quiet)
        fmt::print(stderr,
                   "trade: not all pictures are drawn, since gnuplot is missing or failed, or a scene has no points\n");
    write_whole(out / "report.html", trade_page(scenes, header, out));
    for (const TradeScene& scene : scenes) fmt::print("{}\n", trade_table(scene));
    fmt::print("{}\n", (out / "report.html").string());
}

}  // namespace

void add_trade_flags(CLI::App& command, TradeFlags& flags)
{
    command.add_option("scenes", flags.scenes, "Scenes; none: seed, hang, flag and twist");
    add_common_flags(command, flags.common);
    add_sweep_flags(command, flags.sweep);
    command.add_option("--repeats", flags.repeats, "Times of a point, of which the least counts")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
}

int run_trade(const TradeFlags& flags)
{
    const Shard shard = parse_shard(flags.sweep.shard);
    const bool quiet = flags.common.quiet;
    std::deque<SceneStudy> studies;
    for (const std::string& name : flags.scenes.empty() ? kScenes : flags.scenes) {
        refuse_set(flags.common, {"method", "substeps", "iterations", "tethers", "backend"}, "trade tries them all");
        SceneRun run = prepare_run(flags.common, name);
        if (!sets(flags.common, "threads")) run.params.threads = 1;
        for (const SceneStudy& study : studies)
            if (study.name() == run.scene.name)
                throw Error(fmt::format("{}: two scenes of that name; give each once", run.scene.name));
        studies.emplace_back(std::move(run.scene), run.params);
    }
    const fs::path out = flags.sweep.out;
    make_writable_directory(out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    const std::unique_ptr<Machine> machine = machine_with_gl(quiet);
    const Json header = header_of(studies, *machine, studies.front().asked_params(), flags.repeats);
    PointStore store(out, header);
    if (!quiet) remark_on_points(store, "trade", out);

    TradeOptions options;
    options.repeats = flags.repeats;
    options.with_gpu = machine->gl().has_value();
    std::vector<SweepPoint> points;
    for (SceneStudy& study : studies)
        for (SweepPoint& point : trade_points(study, options)) points.push_back(std::move(point));
    const bool whole = run_sweep(points, shard, store, InterruptibleProgress("trade", quiet));
    machine->check_gl();
    write_report(store.results(), header, out, quiet);
    if (!flags.common.json.empty()) write_whole(flags.common.json, read_text(out / "trade.json"));
    return static_cast<int>(whole ? ExitCode::done : ExitCode::interrupted);
}

void add_merge_flags(CLI::App& command, MergeFlags& flags)
{
    command.add_option("directories", flags.directories, "Directories of the parts of one sweep")->required();
    command.add_option("--out", flags.out, "Directory for the whole")->required();
    command.add_flag("--quiet", flags.quiet, "No talk on stderr");
}

int run_merge(const MergeFlags& flags)
{
    const StoredPoints all = merge_points({flags.directories.begin(), flags.directories.end()}, flags.out);
    if (all.header.value("study", "") != "trade")
        throw Error(fmt::format("{}: its points are of `nuno {}`, which is not to be merged", flags.directories.front(),
                                all.header.value("study", "?")));
    write_points(all, flags.out);
    write_report(all.results, all.header, flags.out, flags.quiet);
    return static_cast<int>(ExitCode::done);
}

}  // namespace nuno
