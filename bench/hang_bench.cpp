// The loads that stiff cloth is judged by: `hang` (a 2 m sheet held by two corners, 0.2 kg/m2, k = 10000 N/m, shear
// half of it, bend 200 N/m, drag 0.2 1/s, gravity (0, -9.81, 1)), `swing` (the same let go from horizontal, drag 0.5
// 1/s) and `sphere` (let go over a ball of 0.4 m, no pins). 120 frames of 1/60 s; the time is the median of the last
// 60. Strain is that of the threads at the end, kinetic energy as the velocities have it; rms_mm of `swing` is how far
// the vertices are at the end from where symplectic Euler takes them with 1000 substeps a frame and no tethers (2000
// move them by 3 mm more).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/stopwatch.h"
#include "model/diagnostics.h"
#include "model/grid_recovery.h"
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
    shuffled,  // the same vertices and faces in any order, as a file may have them; the grid is found again
    mesh       // the same vertices and faces, and no grid is looked for
};

std::uint32_t shuffled_place(std::uint32_t v, std::uint32_t vertex_count) { return v * 7919u % vertex_count; }

void shuffle(SheetSource& source)
{
    const auto count = static_cast<std::uint32_t>(source.mesh.positions.size());
    TriangleMesh mesh = source.mesh;
    for (std::uint32_t v = 0; v < count; ++v) {
        mesh.positions[shuffled_place(v, count)] = source.mesh.positions[v];
        mesh.uvs[shuffled_place(v, count)] = source.mesh.uvs[v];
    }
    for (glm::uvec3& face : mesh.faces)
        for (int k = 0; k < 3; ++k) face[k] = shuffled_place(face[k], count);
    for (std::uint32_t& pin : source.pins) pin = shuffled_place(pin, count);
    source.mesh = mesh;
}

ClothModel make_model(Load load, int count, Layout layout)
{
    SheetSource source;
    const glm::vec3 down = load == Load::hang ? glm::vec3(0, -2, 0) : glm::vec3(0, 0, 2);
    source.mesh = grid_mesh(count, count, {-1, 0, 0}, {2, 0, 0}, down);
    if (load != Load::sphere) source.pins = {0, static_cast<std::uint32_t>(count - 1)};
    if (layout != Layout::mesh) source.columns = source.rows = count;
    if (layout == Layout::shuffled) {
        shuffle(source);
        source.grid_order = recover_grid(source.mesh).value().order;
    }
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

ClothState after_two_seconds(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool,
                             std::vector<double>& frame_s)
{
    const auto solver = make_solver(model, bodies, params, pool);
    ClothState cloth = start_state(model, params);
    solver->upload(cloth);
    for (int frame = 0; frame < 120; ++frame) {
        const Stopwatch watch;
        solver->step({params, frame / 60.0, params.substeps});
        frame_s.push_back(watch.elapsed_ms() / 1000);
    }
    solver->download_positions(cloth.positions);
    solver->download_velocities(cloth.velocities);
    return cloth;
}

double distance_to_converged(const ClothModel& model, SimParams params, const ClothState& cloth)
{
    params.method = Method::symplectic_euler;
    params.substeps = 1000;
    params.tethers = Tethers::none;
    ThreadPool pool(0);
    std::vector<double> unused;
    const ClothState converged = after_two_seconds(model, {}, params, pool, unused);
    double sum = 0;
    for (std::size_t v = 0; v < cloth.positions.size(); ++v) {
        const double d = glm::distance(glm::dvec3(cloth.positions[v]), glm::dvec3(converged.positions[v]));
        sum += d * d;
    }
    return std::sqrt(sum / double(cloth.positions.size()));
}

// The largest strain in the frames that are timed.
double peak_strain(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool)
{
    const auto solver = make_solver(model, bodies, params, pool);
    ClothState cloth = start_state(model, params);
    solver->upload(cloth);
    double peak = 0;
    for (int frame = 0; frame < 120; ++frame) {
        solver->step({params, frame / 60.0, params.substeps});
        if (frame < 60) continue;
        solver->download_positions(cloth.positions);
        peak = std::max(peak, measure(model, cloth, params).max_strain);
    }
    return peak;
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
    ClothState cloth;
    for (auto _ : state) {
        std::vector<double> frame_s;
        cloth = after_two_seconds(model, bodies, params, pool, frame_s);
        std::nth_element(frame_s.begin() + 60, frame_s.begin() + 90, frame_s.end());
        state.SetIterationTime(frame_s[90]);
    }
    const Diagnostics end = measure(model, cloth, params);
    state.counters["strain_percent"] = 100 * end.max_strain;
    state.counters["peak_percent"] = 100 * peak_strain(model, bodies, params, pool);
    state.counters["kinetic_j"] = end.kinetic_j;
    if (load == Load::swing) state.counters["rms_mm"] = 1000 * distance_to_converged(model, params, cloth);
}

#define NUNO_HANG(load, layout, ...)                                    \
    BENCHMARK_CAPTURE(run, load##_##layout, Load::load, Layout::layout) \
        ->Args({__VA_ARGS__})                                           \
        ->UseManualTime()                                               \
        ->Iterations(3)                                                 \
        ->Unit(benchmark::kMillisecond)
// Less than 5 % of strain at the end, as cheaply as can be.
NUNO_HANG(hang, grid, 64, 1, 1);
NUNO_HANG(hang, grid, 128, 2, 1);
NUNO_HANG(hang, grid, 256, 3, 1);
NUNO_HANG(hang, grid, 512, 6, 1);
// More of them, for a calmer motion.
NUNO_HANG(hang, grid, 64, 2, 1);
NUNO_HANG(hang, grid, 128, 3, 1);
NUNO_HANG(hang, grid, 256, 5, 1);
NUNO_HANG(hang, grid, 512, 7, 1);
// The substeps of xpbd that are chosen where none are asked for.
NUNO_HANG(hang, grid, 17, 3, 1);
NUNO_HANG(hang, grid, 64, 7, 1);
NUNO_HANG(hang, grid, 128, 11, 1);
NUNO_HANG(hang, grid, 256, 17, 1);
NUNO_HANG(hang, grid, 128, 11, 2);
NUNO_HANG(hang, grid, 256, 17, 2);
NUNO_HANG(hang, grid, 512, 7, 2);
NUNO_HANG(hang, shuffled, 128, 3, 1);
NUNO_HANG(hang, shuffled, 256, 5, 1);
// As many substeps for a grid and a mesh.
NUNO_HANG(hang, grid, 128, 4, 1);
NUNO_HANG(hang, mesh, 128, 4, 1);
NUNO_HANG(hang, mesh, 256, 6, 1);
NUNO_HANG(swing, grid, 128, 8, 1);
NUNO_HANG(swing, grid, 128, 11, 1);
NUNO_HANG(sphere, grid, 128, 20, 1);
NUNO_HANG(sphere, grid, 256, 45, 1);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
