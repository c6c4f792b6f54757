// The implicit methods: their preconditioner, what grids and meshes have in common, threads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/diagnostics.h"
#include "solver/implicit/cpu_implicit.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

SimParams implicit_params(Method method)
{
    SimParams params = on_cpu(method);
    params.frame_rate = 60;
    return params;
}

struct Outcome
{
    ClothState state;
    SolveCounts counts;
};

Outcome run_frames(const ClothModel& model, const SimParams& params, const ClothState& start, int frames,
                   int threads = 1)
{
    ThreadPool pool(threads);
    CpuImplicit solver(model, kNoBodies, params, pool);
    solver.upload(start);
    for (int frame = 0; frame < frames; ++frame)
        solver.step({params, frame / double(params.frame_rate), params.substeps});
    return {state_of(solver, model), solver.counts()};
}

class ImplicitTest : public testing::TestWithParam<Method>
{};

INSTANTIATE_TEST_SUITE_P(methods, ImplicitTest, testing::Values(Method::implicit_euler, Method::sdirk2), kMethodName);

// The preconditioner is as good on a fine grid as on a coarse one.
TEST_P(ImplicitTest, iterations_a_solve_do_not_grow_with_the_grid)
{
    SimParams params = implicit_params(GetParam());
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.gravity_z = 1;
    for (const int side : {17, 33, 65, 129}) {
        const ClothModel model = square_cloth(side, 2, {0, static_cast<std::uint32_t>(side - 1)});
        const Outcome end = run_frames(model, params, start_state(model, params), side > 100 ? 4 : 20);
        EXPECT_LT(double(end.counts.iterations) / double(end.counts.solves), 5) << side;
        EXPECT_EQ(end.counts.capped, 0) << side;
    }
}

TEST_P(ImplicitTest, any_number_of_columns_and_rows_and_a_mesh_give_the_same_cloth)
{
    SimParams params = implicit_params(GetParam());
    params.structural_stiffness = params.shear_stiffness = 500;
    params.bend_stiffness = 0;
    params.gravity_z = 1;
    params.tolerance = 1e-6f;
    for (const int columns : {9, 14}) {
        SheetSource source;
        source.mesh = grid_mesh(columns, 21, {0, 0, 0}, {0.5f, 0, 0}, {0, -1, 0});
        source.columns = columns;
        source.rows = 21;
        source.pins = {0, static_cast<std::uint32_t>(columns - 1)};
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        // The same springs, as a mesh that does not know of its rows.
        ClothModel mesh = model;
        mesh.sheets[0].columns = mesh.sheets[0].rows = 0;
        const ClothState start = start_state(model, params);
        const Outcome grid = run_frames(model, params, start, 20), other = run_frames(mesh, params, start, 20);
        EXPECT_LT(rms_distance(grid.state, other.state), 1e-3) << columns;
        EXPECT_LT(double(other.counts.iterations) / double(other.counts.solves), 12);
        EXPECT_GT(glm::distance(glm::vec3(grid.state.positions.back()), glm::vec3(start.positions.back())), 0.01f);
    }
}

// A strip whose every vertex is held but one, and a sheet without any pin.
TEST_P(ImplicitTest, held_vertices_stay_and_free_sheets_fall)
{
    const ClothModel model = square_cloth(12, 1);
    SimParams params = implicit_params(GetParam());
    params.damping = 0;
    ClothState start = start_state(model, params);
    for (std::size_t i = 1; i < start.positions.size(); ++i) start.positions[i].w = 0;
    const Outcome held = run_frames(model, params, start, 10);
    for (std::size_t i = 1; i < start.positions.size(); ++i) EXPECT_EQ(held.state.positions[i], start.positions[i]);
    EXPECT_LT(held.state.positions[0].y, start.positions[0].y);

    start = start_state(model, params);
    const Outcome free = run_frames(model, params, start, 30);
    const double fall = GetParam() == Method::implicit_euler ? 0.5 * 9.81 * 0.25 * (1 + 1.0 / 30) : 0.5 * 9.81 * 0.25;
    for (std::size_t i = 0; i < start.positions.size(); ++i)
        EXPECT_NEAR(double(start.positions[i].y - free.state.positions[i].y), fall, 2e-3 * fall);
}

// A limp strip that hangs by its top row in steady wind U is straight, at an angle th to the vertical of
// sin th / cos^2 th = q = rho Cn U^2 / (2 sigma g): 28.30 degrees at 1 m/s.
TEST_P(ImplicitTest, a_strip_hangs_in_the_wind_at_the_angle_of_its_drag)
{
    SheetSource source;
    source.mesh = grid_mesh(4, 17, {0, 0, 0}, {0.1f, 0, 0}, {0, -1, 0});
    source.columns = 4;
    source.rows = 17;
    source.pins = {0, 1, 2, 3};
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    SimParams params = implicit_params(GetParam());
    params.structural_stiffness = 1e4f;
    params.damping = 2;
    params.wind_model = WindModel::aero;
    params.wind_z = 1;
    params.skin_coefficient = 0;
    const Outcome end = run_frames(model, params, start_state(model, params), 600);
    const glm::vec4 tip = end.state.positions.back();
    expect_measured(fmt::format("limp strip in wind of 1 m/s, {}: angle, degrees", name_of(GetParam())),
                    std::atan2(double(tip.z), -double(tip.y)) * 180 / M_PI, 28.30, 0.5);
}

// A row of cells a millionth as wide as long: its springs are shorter than the way of a substep, which the tangent knows
// nothing of.
TEST_P(ImplicitTest, springs_shorter_than_the_way_of_a_substep_make_no_energy)
{
    SheetSource sheet = square_mesh(9, 1);
    for (glm::vec3& p : sheet.mesh.positions)
        if (p.y == -0.125f) p.y *= 1e-6f;
    const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
    SimParams params = implicit_params(GetParam());
    params.internal_model = InternalModel::fabric_springs;
    params.bending_warp = params.bending_weft = params.bending_bias = 0;
    params.gravity_y = 0;
    ClothState state = start_state(model, params);
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        state.velocities[v].z = std::cos(10 * (state.positions[v].x + state.positions[v].y));
    const double before = measure(model, state, params).kinetic_j;
    for (const int substeps : {1, 4, 20}) {
        params.substeps = substeps;
        const ClothState end = run_frames(model, params, state, 20).state;
        ASSERT_EQ(first_lost(end.positions), std::nullopt) << substeps;
        const Diagnostics after = measure(model, end, params);
        EXPECT_LE(after.kinetic_j + after.elastic_j, 1.01 * before) << substeps;
        EXPECT_GT(after.kinetic_j, 0.01 * before) << substeps;
    }
}

class ImplicitThreadsTest : public ImplicitTest
{};
INSTANTIATE_TEST_SUITE_P(methods, ImplicitThreadsTest, testing::Values(Method::implicit_euler, Method::sdirk2),
                         kMethodName);

TEST_P(ImplicitThreadsTest, one_two_and_three_threads_give_the_same_bits)
{
    const ClothModel grid = square_cloth(97, 1, {0, 96});
    ClothModel mesh = grid;
    mesh.sheets[0].columns = mesh.sheets[0].rows = 0;
    SimParams params = implicit_params(GetParam());
    params.structural_stiffness = 1e3f;
    params.gravity_z = 2;
    for (const bool is_grid : {true, false}) {
        const ClothModel& model = is_grid ? grid : mesh;
        const ClothState start = start_state(model, params);
        const std::uint64_t one = state_hash(run_frames(model, params, start, 2, 1).state);
        for (const int threads : {2, 3}) EXPECT_EQ(state_hash(run_frames(model, params, start, 2, threads).state), one);
    }
}

}  // namespace
}  // namespace nuno
