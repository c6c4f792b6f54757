// `nuno stability`.
#include "app/stability_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "sim/run_recorder.h"
#include "study/stability_report.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSide = 9;  // vertices along the longer side, where nothing else is asked for
constexpr MapSize kCoarse{5, 7};

// Results do not depend on the machine, nor on the number of threads.
Json header_of(const std::vector<std::pair<Scene, SimParams>>& runs, MapSize size)
{
    Json scenes;
    for (const auto& [scene, asked] : runs) {
        SimParams params = asked;
        params.threads = 0;
        scenes[scene.name] = {{"text", read_text(scene.path)}, {"params", params_json(sim_param_table(), &params)}};
    }
    return {{"study", "stability"},
            {"version", fmt::format("{} ({})", kVersion, kCommit)},
            {"columns", size.columns},
            {"rows", size.rows},
            {"scenes", scenes}};
}

std::vector<std::pair<Scene, SimParams>> runs_of(const StabilityFlags& flags)
{
    std::vector<std::pair<Scene, SimParams>> runs;
    for (const std::string& name : flags.scenes.empty() ? std::vector<std::string>{"seed"} : flags.scenes) {
        SceneRun run = prepare_run(flags.common, name);
        const auto is_grid = [](const SheetSpec& sheet) { return sheet.mesh.empty(); };
        if (!std::all_of(run.scene.sheets.begin(), run.scene.sheets.end(), is_grid))
            throw Error(fmt::format(
                "{}: has a sheet that is a mesh, whose size cannot be chosen; stability maps need scenes of grids",
                run.scene.name));
        if (!sets(flags.common, "resolution")) run.params.resolution = kSide;
        if (!sets(flags.common, "method")) run.params.method = Method::automatic;
        run.params.backend = Backend::cpu;
        runs.emplace_back(std::move(run.scene), run.params);
    }
    return runs;
}

std::vector<StabilityScene> scenes_of(const std::vector<std::pair<Scene, SimParams>>& runs, MapSize size)
{
    std::vector<StabilityScene> scenes;
    for (const auto& [scene, params] : runs) {
        StabilityScene& added = scenes.emplace_back();
        added.maps = std::make_unique<StabilityMaps>(scene, params, size);
        added.extremes = extreme_cases(added.maps->methods());
    }
    return scenes;
}

// Ids of points have their scene before them.
std::vector<SweepPoint> points_of(const std::vector<std::pair<Scene, SimParams>>& runs,
                                  const std::vector<StabilityScene>& scenes)
{
    std::vector<SweepPoint> points;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::vector<SweepPoint> of_scene = extreme_points(runs[i].first, runs[i].second, scenes[i].extremes);
        for (SweepPoint& point : scenes[i].maps->points()) of_scene.push_back(std::move(point));
        for (SweepPoint& point : of_scene)
            points.push_back({scenes[i].name() + "/" + point.id, std::move(point.measure)});
    }
    return points;
}

void take_results(const std::map<std::string, Json>& all, std::vector<StabilityScene>& scenes)
{
    for (StabilityScene& scene : scenes)
        for (const auto& [id, result] : all)
            if (id.starts_with(scene.name() + "/")) scene.results[id.substr(scene.name().size() + 1)] = result;
}

void write_report(const std::vector<StabilityScene>& scenes, const Json& header, const fs::path& out, bool quiet)
{
    write_whole(out / "stability.csv", stability_csv(scenes));
    write_whole(out / "stability.json", Json{{"header", header}, {"scenes", stability_json(scenes)}}.dump(1) + "\n");
    bool drawn = true;
    for (const StabilityScene& scene : scenes) drawn = draw_stability(scene, out) && drawn;
    if (!drawn && !quiet)
        fmt::print(stderr, "stability: no pictures, since gnuplot is missing or failed; {} holds the data\n",
                   (out / "stability.csv").string());
    write_whole(out / "report.html", stability_page(scenes, header, out));
    for (const StabilityScene& scene : scenes) fmt::print("{}\n", stability_table(scene));
    fmt::print("{}\n", (out / "report.html").string());
}

}  // namespace

void add_stability_flags(CLI::App& command, StabilityFlags& flags)
{
    command.add_option("scenes", flags.scenes, "Scenes; none: seed");
    add_common_flags(command, flags.common);
    add_sweep_flags(command, flags.sweep);
    command.add_flag("--coarse", flags.coarse, "Maps of few cells");
}

int run_stability(const StabilityFlags& flags)
{
    const Shard shard = parse_shard(flags.sweep.shard);
    const bool quiet = flags.common.quiet;
    const MapSize size = flags.coarse ? kCoarse : MapSize{};
    const std::vector<std::pair<Scene, SimParams>> runs = runs_of(flags);
    const fs::path out = flags.sweep.out;
    make_writable_directory(out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    std::vector<StabilityScene> scenes = scenes_of(runs, size);
    const Json header = header_of(runs, size);
    PointStore store(out, header);
    if (!quiet) remark_on_points(store, "stability", out);
    ThreadPool pool(runs.front().second.threads);
    const bool whole =
        run_sweep(points_of(runs, scenes), shard, store, pool, InterruptibleProgress("stability", quiet));
    take_results(store.results(), scenes);
    write_report(scenes, header, out, quiet);
    if (!flags.common.json.empty()) write_whole(flags.common.json, read_text(out / "stability.json"));
    if (!whole) return static_cast<int>(ExitCode::interrupted);
    const bool all_hold = std::all_of(scenes.begin(), scenes.end(), [](const StabilityScene& s) { return holds(s); });
    return static_cast<int>(all_hold ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
