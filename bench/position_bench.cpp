// Vertex block descent and xpbd in colours and all springs at once, on the CPU and in compute shaders: time a particle
// and substep, and the strain that it leaves of `hang` (bench/hang_bench.cpp) after 2 s.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "gl/egl_context.h"
#include "model/diagnostics.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

ClothModel make_model(int count)
{
    SheetSource source;
    source.mesh = grid_mesh(count, count, {-1, 0, 0}, {2, 0, 0}, {0, -2, 0});
    source.columns = source.rows = count;
    source.pins = {0, static_cast<std::uint32_t>(count - 1)};
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

SimParams make_params(Backend backend, Method method, Sweep sweep, int substeps)
{
    SimParams params;
    params.backend = backend;
    params.method = method;
    params.sweep = sweep;
    params.substeps = substeps;
    params.tethers = Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = 0.04f;
    params.gravity_z = 1;
    return params;
}

// Arguments: vertices a side, substeps a frame, threads.
void run(benchmark::State& state, Backend backend, Method method, Sweep sweep)
{
    static const std::unique_ptr<Context> context = make_headless_context();
    const ClothModel model = make_model(static_cast<int>(state.range(0)));
    const SimParams params = make_params(backend, method, sweep, static_cast<int>(state.range(1)));
    ThreadPool pool(static_cast<int>(state.range(2)));
    const Bodies none;
    const auto solver = make_solver(model, none, params, pool);
    ClothState cloth = start_state(model, params);
    solver->upload(cloth);
    int frame = 0;
    for (auto _ : state) {
        solver->step({params, frame++ / 60.0, params.substeps});
        solver->finish();
    }
    // Seconds a particle and substep; the console shows them as "4.2n".
    state.counters["s_per_particle_and_substep"] =
        benchmark::Counter(double(state.iterations()) * params.substeps * double(model.vertex_count()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    solver->upload(cloth);
    for (frame = 0; frame < 120; ++frame) solver->step({params, frame / 60.0, params.substeps});
    solver->download_positions(cloth.positions);
    solver->download_velocities(cloth.velocities);
    const Diagnostics end = measure(model, cloth, params);
    state.counters["strain_percent"] = 100 * end.max_strain;
    state.counters["kinetic_j"] = end.kinetic_j;
    if (backend == Backend::gpu) state.SetLabel(gl_info().renderer + (gl_info().software ? " (a CPU's time)" : ""));
}

#define NUNO_POSITION(backend, method, sweep)                                                            \
    BENCHMARK_CAPTURE(run, backend##_##method##_##sweep, Backend::backend, Method::method, Sweep::sweep) \
        ->Args({17, 5, 1})                                                                               \
        ->Args({32, 5, 1})                                                                               \
        ->Args({64, 5, 1})                                                                               \
        ->Args({128, 9, 1})                                                                              \
        ->UseRealTime()                                                                                  \
        ->MinTime(0.2)                                                                                   \
        ->Unit(benchmark::kMillisecond)
NUNO_POSITION(cpu, vbd, automatic);
NUNO_POSITION(gpu, vbd, automatic);
NUNO_POSITION(cpu, xpbd, rows);
NUNO_POSITION(cpu, xpbd, coloured);
NUNO_POSITION(gpu, xpbd, coloured);
NUNO_POSITION(cpu, xpbd, jacobi);
NUNO_POSITION(gpu, xpbd, jacobi);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
