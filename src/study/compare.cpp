// The CPU against the GPU.
#include "study/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/quantile.h"
#include "core/stopwatch.h"
#include "model/oscillator.h"
#include "model/stability.h"
#include "sim/simulation.h"
#include "solver/method_choice.h"
#include "solver/method_table.h"
#include "study/trade_settings.h"

namespace nuno {
namespace {

constexpr int kMostTimedFrames = 24, kLeastTimedFrames = 4, kFramesATurn = 4;
// For both backends of one point: where a scene has one method, and where it has many.
constexpr double kFramesMs = 1500, kFramesOfManyMs = 400;
// A frame; a method that needs more is left out where every one is tried.
constexpr int kMostSubsteps = 2000;

BackendCost cost_of(const std::vector<FrameStats>& frames, std::uint32_t particles, int substeps)
{
    BackendCost cost;
    const auto median_of = [&](auto ms_of) {
        std::vector<double> ms;
        for (const FrameStats& frame : frames) ms.push_back(ms_of(frame.stage_ms));
        return median(ms);
    };
    for (const StageInfo& stage : kStages)
        cost.stage_ms.*stage.ms = median_of([&](const StageTimes& t) { return t.*stage.ms; });
    cost.frame_ms = median_of(simulation_ms);
    cost.ns_per_particle_and_substep = cost.stage_ms.solve * 1e6 / (double(particles) * substeps);
    return cost;
}

SimParams on(Backend backend, SimParams params)
{
    params.backend = backend;
    params.sleep_motion = 0;  // times are those of cloth in motion
    return params;
}

// Whole frames on both backends, some at a turn, since each leaves the processor's caches and threads to the other:
// times, and the hashes at the end.
void time_frames(const Scene& scene, const SimParams& params, double enough_ms, ComparePoint& point)
{
    Simulation cpu(scene, on(Backend::cpu, params)), gpu(scene, on(Backend::gpu, params));
    cpu.advance_frame();
    gpu.advance_frame();
    std::vector<FrameStats> cpu_frames, gpu_frames;
    Stopwatch watch;
    while (point.timed_frames < kMostTimedFrames &&
           (point.timed_frames < kLeastTimedFrames || watch.elapsed_ms() < enough_ms))
    {
        for (int k = 0; k < kFramesATurn; ++k) cpu_frames.push_back(cpu.advance_frame());
        for (int k = 0; k < kFramesATurn; ++k) gpu_frames.push_back(gpu.advance_frame());
        point.timed_frames += kFramesATurn;
    }
    point.cpu = cost_of(cpu_frames, point.particles, params.substeps);
    point.gpu = cost_of(gpu_frames, point.particles, params.substeps);
    point.frame_hashes_agree = state_hash(cpu.state()) == state_hash(gpu.state());
}

double largest_difference(const ClothState& a, const ClothState& b)
{
    if (first_lost(a.positions) || first_lost(b.positions)) return -1;
    double largest = 0;
    for (std::size_t v = 0; v < a.positions.size(); ++v)
        largest = std::max(largest, glm::distance(glm::dvec3(a.positions[v]), glm::dvec3(b.positions[v])));
    return largest;
}

// The same substeps on both backends from the same start, compared on the way.
void compare_substeps(const ClothModel& model, const Bodies& bodies, const SimParams& params, ComparePoint& point)
{
    ThreadPool pool(params.threads);
    ClothState a = start_state(model, params), b = a;
    const auto cpu = make_solver(model, bodies, on(Backend::cpu, params), pool);
    const auto gpu = make_solver(model, bodies, on(Backend::gpu, params), pool);
    cpu->upload(a);
    gpu->upload(b);
    point.substep_hashes_agree = true;
    for (std::size_t k = 0, done = 0; k < kComparedSubsteps.size(); ++k) {
        const StepInput input{params, double(done) * double(substep_s(params)), kComparedSubsteps[k] - int(done)};
        for (const auto& [solver, state] : {std::pair(cpu.get(), &a), std::pair(gpu.get(), &b)}) {
            solver->step(input);
            solver->download_positions(state->positions);
            solver->download_velocities(state->velocities);
        }
        done = std::size_t(kComparedSubsteps[k]);
        point.largest_difference_m[k] = largest_difference(a, b);
        point.substep_hashes_agree = point.substep_hashes_agree && state_hash(a) == state_hash(b);
    }
}

bool has_grid(const Scene& scene)
{
    return std::any_of(scene.sheets.begin(), scene.sheets.end(), [](const SheetSpec& s) { return s.mesh.empty(); });
}

std::vector<int> sizes_of(const Scene& scene, std::span<const int> sizes)
{
    return has_grid(scene) ? std::vector<int>(sizes.begin(), sizes.end()) : std::vector<int>{0};
}

// Left to themselves the backends take their constraints in different orders.
void sweep_in_one_order(SimParams& params)
{
    if (params.method == Method::xpbd && params.sweep == Sweep::automatic) params.sweep = Sweep::coloured;
}

ClothModel model_of(const CompareCase& c, SimParams& params)
{
    params = c.params;
    if (c.size > 0) params.resolution = c.size;
    return build_cloth_model(make_sheets(*c.scene, params), params.mass_lumping);
}

std::string why_left_out(const CompareCase& c, const MethodInfo& info)
{
    if (!can_run(info, c.params)) return "does not take the scene's parameters";
    if (!is_explicit(info.method)) return "";
    SimParams params;
    const ClothModel model = model_of(c, params);
    const int least = least_stable_substeps(model, params);
    if (least == 0) return "holds with no number of substeps";
    return least > kMostSubsteps ? fmt::format("needs {} substeps a frame", least) : "";
}

}  // namespace

std::string CompareCase::id() const
{
    return fmt::format("{}/{}/{}", scene->name, choice_names(Method{})[std::size_t(params.method)], size);
}

std::vector<CompareCase> compare_cases(const std::vector<std::pair<Scene, SimParams>>& runs, std::span<const int> sizes)
{
    std::vector<CompareCase> cases;
    for (const auto& [scene, params] : runs)
        for (const int size : sizes_of(scene, sizes)) cases.push_back({&scene, params, size, kFramesMs});
    return cases;
}

MethodCases method_cases(const std::vector<std::pair<Scene, SimParams>>& runs, std::span<const Method> methods,
                         std::span<const int> sizes)
{
    MethodCases found;
    for (const MethodInfo& info : method_table())
        if (methods.empty() && !info.on(Backend::gpu))
            found.left_out.push_back(fmt::format("{}: runs on the CPU alone", info.name));
    for (const auto& [scene, params] : runs)
        for (const int size : sizes_of(scene, sizes))
            for (const MethodInfo& info : method_table()) {
                if (!info.on(Backend::cpu) || !info.on(Backend::gpu)) continue;
                if (!methods.empty() && std::find(methods.begin(), methods.end(), info.method) == methods.end())
                    continue;
                const CompareCase c{&scene, with_setting(params, of_method(info, params)), size, kFramesOfManyMs};
                const std::string reason = why_left_out(c, info);
                if (reason.empty())
                    found.cases.push_back(c);
                else
                    found.left_out.push_back(fmt::format("{}, {}, {}: {}", scene.name, info.name, size, reason));
            }
    return found;
}

ComparePoint compare_point(const CompareCase& c)
{
    ComparePoint point;
    point.scene = c.scene->name;
    point.size = c.size;
    SimParams params;
    const ClothModel model = model_of(c, params);
    params = resolve_params(model, c.scene->bodies, params);
    sweep_in_one_order(params);
    params.substeps = std::max(params.substeps, least_stable_substeps(model, params));
    point.particles = model.vertex_count();
    point.method = params.method;
    point.substeps = params.substeps;
    compare_substeps(model, c.scene->bodies, params, point);
    try {
        time_frames(*c.scene, params, c.frames_ms, point);
    } catch (const Error& error) {
        if (error.code() != ExitCode::went_bad) throw;
        point.failure = error.what();
    }
    return point;
}

std::vector<ComparePoint> compare_backends(const std::vector<std::pair<Scene, SimParams>>& runs,
                                           std::span<const int> sizes, const CompareProgress& progress)
{
    const std::vector<CompareCase> cases = compare_cases(runs, sizes);
    std::vector<ComparePoint> points;
    for (const CompareCase& c : cases) {
        if (!progress(int(points.size()), int(cases.size()), c.scene->name + " " + std::to_string(c.size))) break;
        points.push_back(compare_point(c));
    }
    return points;
}

bool backends_agree(const std::vector<ComparePoint>& points, bool software_gl)
{
    return std::all_of(points.begin(), points.end(), [&](const ComparePoint& p) {
        const bool finite =
            std::all_of(p.largest_difference_m.begin(), p.largest_difference_m.end(), [](double d) { return d >= 0; });
        if (!p.failure.empty()) return false;
        if (software_gl) return finite && p.substep_hashes_agree && p.frame_hashes_agree;
        return finite && p.largest_difference_m[0] <= 1e-5;
    });
}

}  // namespace nuno
