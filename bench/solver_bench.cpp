// Time a particle and substep of the solvers, on the CPU and in compute shaders: grid, mesh in the order of rows, mesh
// out of order.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <random>

#include "gl/egl_context.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

enum class Layout
{
    grid,
    mesh,
    shuffled_mesh
};

// A 2 m sheet; the shuffled one has its vertices in random order within windows of 64.
ClothModel make_model(int side, Layout layout)
{
    SheetSource source;
    source.mesh = grid_mesh(side, side, {0, 0, 0}, {2, 0, 0}, {0, -2, 0});
    source.pins = {0, static_cast<std::uint32_t>(side - 1)};
    if (layout == Layout::grid) source.columns = source.rows = side;
    if (layout == Layout::shuffled_mesh) {
        std::vector<std::uint32_t> place(source.mesh.positions.size());
        for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
        std::mt19937 random(1);
        for (auto window = place.begin(); place.end() - window >= 64; window += 64)
            std::shuffle(window, window + 64, random);
        const TriangleMesh ordered = source.mesh;
        for (std::size_t i = 0; i < place.size(); ++i) source.mesh.positions[place[i]] = ordered.positions[i];
        for (glm::uvec3& face : source.mesh.faces) face = {place[face.x], place[face.y], place[face.z]};
    }
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

void run(benchmark::State& state, Backend backend, Layout layout)
{
    static const std::unique_ptr<Context> context = make_headless_context();
    constexpr int kSubsteps = 50;
    const ClothModel model = make_model(static_cast<int>(state.range(0)), layout);
    const Bodies bodies;
    ThreadPool pool(static_cast<int>(state.range(1)));
    SimParams params;
    params.backend = backend;
    params.substeps = 1000;
    params.wind_strength = 1;
    const auto solver = make_solver(model, bodies, params, pool);
    solver->upload(start_state(model, params));
    solver->step({params, 0, kSubsteps});
    for (auto _ : state) {
        solver->step({params, 0, kSubsteps});
        solver->finish();
    }
    // Seconds a particle and substep; the console shows them as "4.2n".
    state.counters["s_per_particle_and_substep"] =
        benchmark::Counter(double(state.iterations()) * kSubsteps * double(model.vertex_count()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    if (backend == Backend::gpu) state.SetLabel(gl_info().renderer + (gl_info().software ? " (a CPU's time)" : ""));
}

#define NUNO_BENCH_CPU(layout)                                         \
    BENCHMARK_CAPTURE(run, cpu_##layout, Backend::cpu, Layout::layout) \
        ->ArgsProduct({{17, 64, 128, 256}, {1, 2}})                    \
        ->UseRealTime()
NUNO_BENCH_CPU(grid);
NUNO_BENCH_CPU(mesh);
NUNO_BENCH_CPU(shuffled_mesh);
#define NUNO_BENCH_GPU(layout)                                         \
    BENCHMARK_CAPTURE(run, gpu_##layout, Backend::gpu, Layout::layout) \
        ->ArgsProduct({{17, 64, 128, 256}, {1}})                       \
        ->UseRealTime()
NUNO_BENCH_GPU(grid);
NUNO_BENCH_GPU(mesh);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
