// `nuno trade`.
#include "app/trade_command.h"

#include <fmt/format.h>

#include <deque>

#include "app/machine.h"
#include "app/sweep_scenes.h"
#include "core/error.h"
#include "core/files.h"
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
Json header_of(const std::vector<SweepScene>& scenes, const Machine& machine, int repeats)
{
    return {{"study", "trade"},
            {"version", sweep_version()},
            {"machine", machine_json(machine.info(ThreadPool(0).thread_count()))},
            {"threads", ThreadPool(scenes.front().params.threads).thread_count()},
            {"repeats", repeats},
            {"scenes", scenes_json(scenes)}};
}

// The scenes of a sweep and their points, which go by a header alone.
struct TradeSweep
{
    std::deque<SceneStudy> studies;
    std::vector<SweepPoint> points;
};

TradeSweep sweep_of(std::vector<SweepScene> scenes, const Json& header)
{
    TradeOptions options;
    options.repeats = header.at("repeats");
    options.with_gpu = !header.at("machine").at("gl_renderer").get<std::string>().empty();
    TradeSweep sweep;
    for (SweepScene& scene : scenes) {
        SceneStudy& study = sweep.studies.emplace_back(std::move(scene.scene), scene.params);
        for (SweepPoint& point : trade_points(study, options)) sweep.points.push_back(std::move(point));
    }
    return sweep;
}

std::vector<SweepScene> scenes_of_flags(const TradeFlags& flags)
{
    std::vector<SweepScene> scenes;
    for (const std::string& name : flags.scenes.empty() ? kScenes : flags.scenes) {
        refuse_set(flags.common, {"method", "substeps", "iterations", "tethers", "backend"}, "trade tries them all");
        SceneRun run = prepare_run(flags.common, name);
        if (!sets(flags.common, "threads")) run.params.threads = 1;
        scenes.push_back({name, std::move(run.scene), run.params});
    }
    require_distinct(scenes);
    return scenes;
}

// Tables, pictures and the page, from all points that are there.
void write_report(const std::map<std::string, Json>& results, const SweepState& sweep, const fs::path& out, bool quiet)
{
    const std::vector<TradeScene> scenes = trade_scenes(results);
    write_whole(out / "trade.csv", trade_csv(scenes));
    const Json json{{"header", sweep.header}, {"missing", sweep.missing}, {"scenes", trade_json(scenes)}};
    write_whole(out / "trade.json", json.dump(1) + "\n");
    bool drawn = true;
    for (const TradeScene& scene : scenes) drawn = plot_trade(scene, out) && drawn;
    if (!drawn && !quiet)
        fmt::print(stderr,
                   "trade: not all pictures are drawn, since gnuplot is missing or failed, or a scene has no points\n");
    write_whole(out / "report.html", trade_page(scenes, sweep, out));
    for (const TradeScene& scene : scenes) fmt::print("{}\n", trade_table(scene));
    if (!sweep.missing.empty()) fmt::print("{} of {} points are missing\n", sweep.missing.size(), sweep.count);
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
    std::vector<SweepScene> scenes = scenes_of_flags(flags);
    const fs::path out = flags.sweep.out;
    make_writable_directory(out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    const std::unique_ptr<Machine> machine = machine_with_gl(quiet);
    const Json header = header_of(scenes, *machine, flags.repeats);
    const InterruptibleProgress progress("trade", quiet);  // catches what would cut a line short
    PointStore store(out, header);
    if (!quiet) remark_on_points(store, "trade", out);

    const TradeSweep sweep = sweep_of(std::move(scenes), header);
    const bool whole = run_sweep(sweep.points, shard, store, progress);
    machine->check_gl();
    write_report(store.results(), sweep_state(header, sweep.points, store.results()), out, quiet);
    if (!flags.common.json.empty()) write_whole(flags.common.json, read_text(out / "trade.json"));
    return static_cast<int>(whole ? ExitCode::done : ExitCode::interrupted);
}

SweepState report_trade(const StoredPoints& all, const fs::path& out, bool quiet)
{
    const TradeSweep sweep = sweep_of(scenes_of(all.header), all.header);
    SweepState state = sweep_state(all.header, sweep.points, all.results);
    write_report(all.results, state, out, quiet);
    return state;
}

}  // namespace nuno
