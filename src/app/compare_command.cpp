// `nuno compare`.
#include "app/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/interrupt.h"
#include "app/machine.h"
#include "app/sweep_flags.h"
#include "app/sweep_scenes.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "core/version.h"
#include "sim/start_check.h"
#include "solver/method_table.h"
#include "study/compare.h"
#include "study/compare_plot.h"
#include "study/sweep.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSizeOfMany = 33;  // vertices along the longer side, where every method is run

// Where layers cross or touch at the start of a scene, in its own size.
void remark_on_start(const Scene& scene, const SimParams& params)
{
    const ClothModel model = build_cloth_model(make_sheets(scene, params), params.mass_lumping);
    ClothState state = start_state(model, params);
    ThreadPool pool(params.threads);
    for (const std::string& line : start_remarks(check_start(model, params, state.positions, pool), params))
        fmt::print(stderr, "{}: {}\n", scene.name, line);
}

std::vector<SweepScene> scenes_of_flags(const CompareFlags& flags)
{
    std::vector<SweepScene> scenes;
    for (const std::string& name : flags.scenes.empty() ? scene_names() : flags.scenes) {
        SceneRun run = prepare_run(flags.common, name);
        if (!flags.common.quiet) remark_on_start(run.scene, run.params);
        scenes.push_back({name, std::move(run.scene), run.params});
    }
    return scenes;
}

std::vector<Method> methods_of_flags(const CompareFlags& flags)
{
    std::vector<std::string_view> names;
    for (const MethodInfo& info : method_table())
        if (info.on(Backend::cpu) && info.on(Backend::gpu)) names.push_back(info.name);
    std::vector<Method> methods;
    for (const std::string& wanted : flags.methods) {
        if (std::find(names.begin(), names.end(), wanted) == names.end())
            throw Error(
                fmt::format("--methods {}: is no method of both backends; choose {}", wanted, join_choices(names)));
        for (const MethodInfo& info : method_table())
            if (info.name == wanted) methods.push_back(info.method);
    }
    return methods;
}

// What was run, and what was not.
struct Outcome
{
    std::vector<ComparePoint> points;
    std::vector<std::string> left_out;
    bool whole = true;
};

// Each scene with its own method, anew.
Outcome compare_scenes(const std::vector<std::pair<Scene, SimParams>>& runs, std::span<const int> sizes, bool quiet)
{
    Outcome outcome;
    InterruptibleProgress progress("compare", quiet);
    outcome.points = compare_backends(runs, sizes, [&](int done, int total, const std::string&) {
        return progress(std::size_t(done), std::size_t(total));
    });
    outcome.whole = !interrupted();
    return outcome;
}

// Each scene with each method; points that are in the directory already stay.
Outcome compare_methods(const std::vector<std::pair<Scene, SimParams>>& runs, std::span<const int> sizes,
                        const CompareFlags& flags, const Json& header)
{
    const MethodCases all = method_cases(runs, methods_of_flags(flags), sizes);
    const InterruptibleProgress progress("compare", flags.common.quiet);  // catches what would cut a line short
    PointStore store(flags.out, header);
    if (!flags.common.quiet) remark_on_points(store, "compare", flags.out);
    std::vector<SweepPoint> points;
    for (const CompareCase& c : all.cases)
        points.push_back({c.id(), [&c] { return compare_json({compare_point(c)}).at(0); }});
    Outcome outcome{{}, all.left_out, true};
    outcome.whole = run_sweep(points, {}, store, progress);
    for (const SweepPoint& point : points)
        if (store.holds(point.id)) outcome.points.push_back(compare_point_of(store.results().at(point.id)));
    return outcome;
}

void write_report(const Outcome& outcome, const MachineInfo& info, const CompareFlags& flags, bool many)
{
    const std::filesystem::path out = flags.out;
    const bool software = info.software_gl;
    const std::string table = compare_table(outcome.points, software);
    fmt::print("{}", table);
    for (const ComparePoint& point : outcome.points)
        if (!point.failure.empty()) fmt::print(stderr, "nuno: {}\n", point.failure);
    const Json machine = machine_json(info);
    const Json json = {{"program", {{"name", "nuno"}, {"version", kVersion}, {"commit", kCommit}}},
                       {"machine", machine},
                       {"points", compare_json(outcome.points)},
                       {"left_out", outcome.left_out}};
    write_whole(out / "compare.json", json.dump(1) + "\n");
    write_whole(out / "compare.txt", table);
    if (!flags.common.json.empty()) write_whole(flags.common.json, json.dump(1) + "\n");
    if (!(many ? plot_ratios(outcome.points, software, out) : plot_comparison(outcome.points, software, out)))
        fmt::print(stderr, "compare: no picture, since gnuplot is missing or failed; {} holds its data\n",
                   (out / (many ? "compare.json" : "compare.dat")).string());
    write_whole(out / "report.html", compare_page(outcome.points, outcome.left_out, machine, out));
}

}  // namespace

void add_compare_flags(CLI::App& command, CompareFlags& flags)
{
    command.add_option("scenes", flags.scenes, "Scenes; none: all of `nuno scenes`");
    add_common_flags(command, flags.common);
    command.add_option("--out", flags.out, "Directory for data, pictures and report.html")->capture_default_str();
    command.add_flag("--all", flags.all, "Every method that both backends have; run again to go on");
    command.add_option("--methods", flags.methods, "These methods, with commas; run again to go on")->delimiter(',');
    command.add_option("--sizes", flags.sizes, "Vertices along the longer side of grids, with commas")
        ->delimiter(',')
        ->check(CLI::Range(2, 2048));
}

int run_compare(const CompareFlags& flags)
{
    const bool many = flags.all || !flags.methods.empty();
    if (flags.all && !flags.methods.empty()) throw Error("--all and --methods: give one of the two");
    if (many) refuse_set(flags.common, {"method"}, "every method is run in turn");
    methods_of_flags(flags);
    const std::vector<SweepScene> scenes = scenes_of_flags(flags);
    std::vector<std::pair<Scene, SimParams>> runs;
    for (const SweepScene& scene : scenes) runs.emplace_back(scene.scene, scene.params);
    std::vector<int> sizes = flags.sizes;
    if (sizes.empty())
        sizes = many ? std::vector{kSizeOfMany} : std::vector(kComparedSizes.begin(), kComparedSizes.end());
    if (many) require_distinct(scenes);
    make_writable_directory(flags.out);
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    const Machine machine(true);
    const MachineInfo info = machine.info(ThreadPool(runs.front().second.threads).thread_count());
    const Json header{{"study", "compare"},
                      {"version", sweep_version()},
                      {"machine", machine_json(info)},
                      {"scenes", scenes_json(scenes)}};
    const Outcome outcome =
        many ? compare_methods(runs, sizes, flags, header) : compare_scenes(runs, sizes, flags.common.quiet);
    write_report(outcome, info, flags, many);
    machine.check_gl();
    if (!outcome.whole) return static_cast<int>(ExitCode::interrupted);
    const bool agree = backends_agree(outcome.points, machine.gl()->software);
    return static_cast<int>(agree ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
