// The loads that stiff cloth is judged by: `hang` (a 2 m sheet held by two corners, 0.2 kg/m2, k = 10000 N/m, shear
// half of it, bend 200 N/m, drag 0.2 1/s, gravity (0, -9.81, 1)), `swing` (the same let go from horizontal, drag 0.5
// 1/s) and `sphere` (let go over a ball of 0.4 m, no pins). 120 frames of 1/60 s; the time is the median of the last
// 60. Strain is that of the threads at the end, kinetic energy as the velocities have it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/stopwatch.h"
#include "model/diagnostics.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

enum class Load
{
    hang,
    swing,
    sphere
};
enum class Layout
{
    grid,
    mesh  // the same vertices and faces without rows and columns
};

ClothModel make_model(Load load, int count, Layout layout)
{
    SheetSource source;
    const glm::vec3 down = load == Load::hang ? glm::vec3(0, -2, 0) : glm::vec3(0, 0, 2);
    source.mesh = grid_mesh(count, count, {-1, 0, 0}, {2, 0, 0}, down);
    if (layout == Layout::grid) source.columns = source.rows = count;
    if (load != Load::sphere) source.pins = {0, static_cast<std::uint32_t>(count - 1)};
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

SimParams make_params(Load load, int substeps)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = Method::xpbd;
    params.substeps = substeps;
    params.tethers = load == Load::sphere ? Tethers::none : Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = (load == Load::swing ? 0.5f : 0.2f) * params.areal_density;
    params.gravity_z = 1;
    params.thickness = 0;
    return params;
}

// Arguments: vertices a side, substeps a frame, threads.
void run(benchmark::State& state, Load load, Layout layout)
{
    const ClothModel model = make_model(load, static_cast<int>(state.range(0)), layout);
    const SimParams params = make_params(load, static_cast<int>(state.range(1)));
    Bodies bodies;
    if (load == Load::sphere) {
        Sphere& sphere = bodies.spheres.emplace_back();
        sphere.centre = {0, -0.42f, 1};
        sphere.radius = 0.4f;
    }
    ThreadPool pool(static_cast<int>(state.range(2)));
    ClothState cloth = start_state(model, params);
    for (auto _ : state) {
        const auto solver = make_solver(model, bodies, params, pool);
        cloth = start_state(model, params);
        solver->upload(cloth);
        std::vector<double> frame_s;
        for (int frame = 0; frame < 120; ++frame) {
            const Stopwatch watch;
            solver->step({params, frame / 60.0, params.substeps});
            frame_s.push_back(watch.elapsed_ms() / 1000);
        }
        std::nth_element(frame_s.begin() + 60, frame_s.begin() + 90, frame_s.end());
        state.SetIterationTime(frame_s[90]);
        solver->download_positions(cloth.positions);
        solver->download_velocities(cloth.velocities);
    }
    const Diagnostics end = measure(model, cloth, params);
    state.counters["strain_percent"] = 100 * end.max_strain;
    state.counters["kinetic_j"] = end.kinetic_j;
}

#define NUNO_HANG(load, layout, ...)                                    \
    BENCHMARK_CAPTURE(run, load##_##layout, Load::load, Layout::layout) \
        ->Args({__VA_ARGS__})                                           \
        ->UseManualTime()                                               \
        ->Iterations(3)                                                 \
        ->Unit(benchmark::kMillisecond)
// Less than 5 % of strain, as cheaply as can be.
NUNO_HANG(hang, grid, 64, 2, 1);
NUNO_HANG(hang, grid, 128, 4, 1);
NUNO_HANG(hang, grid, 256, 6, 1);
NUNO_HANG(hang, grid, 512, 9, 1);
// The substeps that are chosen where none are asked for.
NUNO_HANG(hang, grid, 17, 3, 1);
NUNO_HANG(hang, grid, 64, 7, 1);
NUNO_HANG(hang, grid, 128, 11, 1);
NUNO_HANG(hang, grid, 256, 17, 1);
NUNO_HANG(hang, grid, 128, 11, 2);
NUNO_HANG(hang, grid, 256, 17, 2);
NUNO_HANG(hang, grid, 512, 9, 2);
NUNO_HANG(hang, mesh, 128, 4, 1);
NUNO_HANG(hang, mesh, 256, 6, 1);
NUNO_HANG(swing, grid, 128, 11, 1);
NUNO_HANG(sphere, grid, 128, 20, 1);
NUNO_HANG(sphere, grid, 256, 50, 1);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
