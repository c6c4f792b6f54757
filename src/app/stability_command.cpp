// `nuno stability`.
#include "app/stability_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/sweep_scenes.h"
#include "core/error.h"
#include "core/files.h"
#include "study/stability_report.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSide = 9;  // vertices along the longer side, where nothing else is asked for
constexpr MapSize kCoarse{5, 7};

// Results do not depend on the machine, nor on the number of threads.
Json header_of(const std::vector<SweepScene>& scenes, MapSize size)
{
    return {{"study", "stability"},
            {"version", sweep_version()},
            {"columns", size.columns},
            {"rows", size.rows},
            {"scenes", scenes_json(scenes)}};
}

std::vector<SweepScene> scenes_of_flags(const StabilityFlags& flags)
{
    std::vector<SweepScene> scenes;
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
        scenes.push_back({name, std::move(run.scene), run.params});
    }
    require_distinct(scenes);
    return scenes;
}

// Studies and points of scenes, which must outlive them. Ids of points have their scene before them.
struct StabilitySweep
{
    std::vector<StabilityScene> studies;
    std::vector<SweepPoint> points;
};

StabilitySweep sweep_of(const std::vector<SweepScene>& scenes, MapSize size)
{
    StabilitySweep sweep;
    for (const auto& [source, scene, params] : scenes) {
        StabilityScene& study = sweep.studies.emplace_back();
        study.maps = std::make_unique<StabilityMaps>(scene, params, size);
        study.extremes = extreme_cases(study.maps->methods());
        std::vector<SweepPoint> points = extreme_points(scene, params, study.extremes);
        for (SweepPoint& point : study.maps->points()) points.push_back(std::move(point));
        for (SweepPoint& point : points)
            sweep.points.push_back({study.name() + "/" + point.id, std::move(point.measure)});
    }
    return sweep;
}

void take_results(const std::map<std::string, Json>& all, std::vector<StabilityScene>& scenes)
{
    for (StabilityScene& scene : scenes)
        for (const auto& [id, result] : all)
            if (id.starts_with(scene.name() + "/")) scene.results[id.substr(scene.name().size() + 1)] = result;
}

// Writes all that a reader gets; what the sweep came to.
SweepState write_report(const std::map<std::string, Json>& results, const Json& header, StabilitySweep& sweep,
                        const fs::path& out, bool quiet)
{
    take_results(results, sweep.studies);
    SweepState state = sweep_state(header, sweep.points, results);
    const std::vector<StabilityScene>& scenes = sweep.studies;
    write_whole(out / "stability.csv", stability_csv(scenes));
    const Json json{{"header", header}, {"missing", state.missing}, {"scenes", stability_json(scenes)}};
    write_whole(out / "stability.json", json.dump(1) + "\n");
    bool drawn = true;
    for (const StabilityScene& scene : scenes) drawn = draw_stability(scene, out) && drawn;
    if (!drawn && !quiet)
        fmt::print(stderr, "stability: no pictures, since gnuplot is missing or failed; {} holds the data\n",
                   (out / "stability.csv").string());
    write_whole(out / "report.html", stability_page(scenes, state, out));
    for (const StabilityScene& scene : scenes) fmt::print("{}\n", stability_table(scene));
    if (!state.missing.empty()) fmt::print("{} of {} points are missing\n", state.missing.size(), state.count);
    fmt::print("{}\n", (out / "report.html").string());
    return state;
}

// Whether nothing that was measured is against it.
bool none_fails(const std::vector<StabilityScene>& scenes)
{
    return std::all_of(scenes.begin(), scenes.end(), [](const StabilityScene& s) { return holds(s).value_or(true); });
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
    std::vector<SweepScene> scenes = scenes_of_flags(flags);
    ThreadPool pool(scenes.front().params.threads);
    for (SweepScene& scene : scenes) scene.params.threads = 0;
    const fs::path out = flags.sweep.out;
    make_writable_directory(out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    StabilitySweep sweep = sweep_of(scenes, size);
    const Json header = header_of(scenes, size);
    const InterruptibleProgress progress("stability", quiet);  // catches what would cut a line short
    PointStore store(out, header);
    if (!quiet) remark_on_points(store, "stability", out);
    const bool whole = run_sweep(sweep.points, shard, store, pool, progress);
    write_report(store.results(), header, sweep, out, quiet);
    if (!flags.common.json.empty()) write_whole(flags.common.json, read_text(out / "stability.json"));
    if (!whole) return static_cast<int>(ExitCode::interrupted);
    return static_cast<int>(none_fails(sweep.studies) ? ExitCode::done : ExitCode::check_failed);
}

SweepState report_stability(const StoredPoints& all, const fs::path& out, bool quiet, bool& holds)
{
    const MapSize size{all.header.at("columns"), all.header.at("rows")};
    const std::vector<SweepScene> scenes = scenes_of(all.header);
    StabilitySweep sweep = sweep_of(scenes, size);
    SweepState state = write_report(all.results, all.header, sweep, out, quiet);
    holds = none_fails(sweep.studies);
    return state;
}

}  // namespace nuno
