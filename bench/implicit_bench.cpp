// Time a frame and particle of the implicit methods on a hanging sheet, 2 m a side and as stiff as the scene `hang`,
// iterations a solve, and how far strains are from those of exact solves.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "core/stopwatch.h"
#include "solver/implicit/cpu_implicit.h"
#include "solver/method_choice.h"

namespace nuno {
namespace {

const Bodies kNoBodies;

ClothModel hanging_sheet(int side)
{
    SheetSource source;
    source.mesh = grid_mesh(side, side, {-1, 0, 0}, {2, 0, 0}, {0, -2, 0});
    source.columns = source.rows = side;
    source.pins = {0, static_cast<std::uint32_t>(side - 1)};
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

SimParams hang_params(Method method)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = 0.04f;
    params.gravity_z = 1;
    return params;
}

struct Strains
{
    double p99 = 0, mean = 0;
};

// Of the threads along rows and columns, stretched or pressed.
Strains strains_of(const ClothModel& model, std::span<const glm::vec4> x)
{
    std::vector<double> all;
    for (const Spring& spring : model.springs)
        if (spring.kind == SpringKind::warp || spring.kind == SpringKind::weft)
            all.push_back(
                std::abs(glm::distance(glm::dvec3(glm::vec3(x[spring.a])), glm::dvec3(glm::vec3(x[spring.b]))) /
                             double(spring.rest_length) -
                         1));
    Strains strains;
    for (const double strain : all) strains.mean += strain / double(all.size());
    const auto p99 = all.begin() + static_cast<std::ptrdiff_t>(0.99 * double(all.size()));
    std::nth_element(all.begin(), p99, all.end());
    strains.p99 = *p99;
    return strains;
}

struct Run
{
    Strains strains;    // means over the last half second; a single frame depends on the swing of the moment
    double frame_s;     // median of the last 60
    double iterations;  // a solve
};

Run run_two_seconds(const ClothModel& model, const SimParams& params, int threads)
{
    ThreadPool pool(threads);
    CpuImplicit solver(model, kNoBodies, params, pool);
    solver.upload(start_state(model, params));
    std::vector<glm::vec4> x(model.vertex_count());
    std::vector<double> frame_s;
    Run run{};
    for (int frame = 0; frame < 120; ++frame) {
        const Stopwatch watch;
        solver.step({params, frame / 60.0, params.substeps});
        if (frame >= 60) frame_s.push_back(watch.elapsed_ms() / 1000);
        if (frame < 90) continue;
        solver.download_positions(x);
        const Strains now = strains_of(model, x);
        run.strains.p99 += now.p99 / 30;
        run.strains.mean += now.mean / 30;
    }
    std::nth_element(frame_s.begin(), frame_s.begin() + 30, frame_s.end());
    run.frame_s = frame_s[30];
    run.iterations = double(solver.counts().iterations) / double(solver.counts().solves);
    return run;
}

// Default settings. Arguments: vertices a side, threads.
void hang(benchmark::State& state, Method method, bool is_grid)
{
    ClothModel model = hanging_sheet(static_cast<int>(state.range(0)));
    const SimParams params = resolve_params(model, kNoBodies, hang_params(method));
    if (!is_grid) model.sheets[0].columns = model.sheets[0].rows = 0;
    for (auto _ : state) {
        const Run run = run_two_seconds(model, params, static_cast<int>(state.range(1)));
        state.SetIterationTime(run.frame_s);
        state.counters["ns_per_particle"] = run.frame_s * 1e9 / double(model.vertex_count());
        state.counters["iterations_a_solve"] = run.iterations;
    }
}
#define NUNO_BENCH_HANG(method, layout, is_grid)                        \
    BENCHMARK_CAPTURE(hang, method##_##layout, Method::method, is_grid) \
        ->ArgsProduct({{64, 128, 256, 512}, {1, 2}})                    \
        ->UseManualTime()                                               \
        ->Iterations(1)                                                 \
        ->Unit(benchmark::kMillisecond)
NUNO_BENCH_HANG(implicit_euler, grid, true);
NUNO_BENCH_HANG(sdirk2, grid, true);
NUNO_BENCH_HANG(implicit_euler, mesh, false);
NUNO_BENCH_HANG(sdirk2, mesh, false);

// Default settings against solves to 1e-3 of that error, in three Newton steps: minutes at 512 a side.
void accuracy(benchmark::State& state, Method method)
{
    const ClothModel model = hanging_sheet(static_cast<int>(state.range(0)));
    const SimParams params = resolve_params(model, kNoBodies, hang_params(method));
    SimParams exact = params;
    exact.tolerance = 1e-4f;
    exact.iterations = 3;
    for (auto _ : state) {
        const Strains strains = run_two_seconds(model, params, 1).strains;
        const Strains converged = run_two_seconds(model, exact, 1).strains;
        state.counters["p99_%"] = 100 * strains.p99;
        state.counters["p99_error_%"] = 100 * (strains.p99 / converged.p99 - 1);
        state.counters["mean_%"] = 100 * strains.mean;
        state.counters["mean_error_%"] = 100 * (strains.mean / converged.mean - 1);
    }
}
#define NUNO_BENCH_ACCURACY(method) \
    BENCHMARK_CAPTURE(accuracy, method, Method::method)->RangeMultiplier(2)->Range(64, 512)->Iterations(1)
NUNO_BENCH_ACCURACY(implicit_euler);
NUNO_BENCH_ACCURACY(sdirk2);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
