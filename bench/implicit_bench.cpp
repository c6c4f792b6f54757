// Time a frame and particle of the implicit methods on a hanging sheet, 2 m a side and as stiff as the scene `hang`, and
// how many iterations a solve takes.
#include <benchmark/benchmark.h>

#include "solver/implicit/cpu_implicit.h"

namespace nuno {
namespace {

const Bodies kNoBodies;

void hang(benchmark::State& state, Method method, bool is_grid)
{
    const int side = static_cast<int>(state.range(0));
    SheetSource source;
    source.mesh = grid_mesh(side, side, {-1, 0, 0}, {2, 0, 0}, {0, -2, 0});
    source.columns = source.rows = side;
    source.pins = {0, static_cast<std::uint32_t>(side - 1)};
    ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    if (!is_grid) model.sheets[0].columns = model.sheets[0].rows = 0;
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.substeps = 1;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = 0.04f;
    params.gravity_z = 1;
    ThreadPool pool(static_cast<int>(state.range(1)));
    CpuImplicit solver(model, kNoBodies, params, pool);
    solver.upload(start_state(model, params));
    int frame = 0;
    const auto step = [&] { solver.step({params, frame++ / 60.0, 1}); };
    while (frame < 30) step();
    const SolveCounts before = solver.counts();
    for (auto _ : state) step();
    const SolveCounts after = solver.counts();
    state.counters["s_per_particle_and_frame"] =
        benchmark::Counter(double(state.iterations()) * double(model.vertex_count()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["iterations_a_solve"] =
        double(after.iterations - before.iterations) / double(after.solves - before.solves);
}

#define NUNO_BENCH_HANG(method, layout, is_grid)                        \
    BENCHMARK_CAPTURE(hang, method##_##layout, Method::method, is_grid) \
        ->ArgsProduct({{64, 128, 256, 512}, {1, 2}})                    \
        ->UseRealTime()                                                 \
        ->Unit(benchmark::kMillisecond)
NUNO_BENCH_HANG(implicit_euler, grid, true);
NUNO_BENCH_HANG(sdirk2, grid, true);
NUNO_BENCH_HANG(implicit_euler, mesh, false);
NUNO_BENCH_HANG(sdirk2, mesh, false);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
