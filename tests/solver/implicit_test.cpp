// The implicit methods: order, damping, their preconditioner, threads, extremes.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "solver/explicit/cpu_reference.h"
#include "solver/implicit/cpu_implicit.h"
#include "support/sheets.h"

namespace nuno {
namespace {

const Bodies kNoBodies;

SimParams implicit_params(Method method)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.substeps = 1;
    return params;
}

struct Outcome
{
    ClothState state;
    SolveCounts counts;
};

Outcome run(const ClothModel& model, const SimParams& params, const ClothState& start, int frames, int threads = 1)
{
    ThreadPool pool(threads);
    CpuImplicit solver(model, kNoBodies, params, pool);
    Outcome result{start, {}};
    solver.upload(start);
    for (int frame = 0; frame < frames; ++frame)
        solver.step({params, frame / double(params.frame_rate), params.substeps});
    solver.download_positions(result.state.positions);
    solver.download_velocities(result.state.velocities);
    result.counts = solver.counts();
    return result;
}

double rms_distance(const ClothState& a, const ClothState& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(a.positions[i]) - glm::dvec3(b.positions[i]);
        sum += glm::dot(d, d);
    }
    return std::sqrt(sum / double(a.positions.size()));
}

// The sheet of accuracy.md A12: 10 x 10 vertices of 5e-4 kg, k 40, 20 and 8 N/m, two pins, 0.2 s.
ClothModel small_sheet() { return square_cloth(10, 0.5f, {0, 9}); }

SimParams small_sheet_params(Method method)
{
    SimParams params = implicit_params(method);
    params.frame_rate = 5;
    params.bend_stiffness = 8;
    params.gravity_z = 1;
    params.tolerance = 1e-10f;
    return params;
}

ClothState reference_of(const ClothModel& model, SimParams params)
{
    params.tolerance = 1e-4f;
    params.iterations = 0;
    ThreadPool pool(1);
    CpuReference solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    solver.upload(state);
    solver.step({params, 0, params.substeps});
    solver.download_positions(state.positions);
    solver.download_velocities(state.velocities);
    return state;
}

class ImplicitTest : public testing::TestWithParam<Method>
{};

INSTANTIATE_TEST_SUITE_P(methods, ImplicitTest, testing::Values(Method::implicit_euler, Method::sdirk2),
                         [](const auto& each) { return std::string(choice_names(Method{})[std::size_t(each.param)]); });

// error ~ h^p: log2 of the ratio of the errors at h and h / 2 is p.
TEST_P(ImplicitTest, error_against_the_reference_falls_at_the_order_of_the_method)
{
    const ClothModel model = small_sheet();
    SimParams params = small_sheet_params(GetParam());
    params.damping = 0.1f;
    params.stiffness_damping = 1e-3f;
    const ClothState exact = reference_of(model, params), start = start_state(model, params);
    double errors[3];
    for (int i = 0; i < 3; ++i) {
        params.substeps = (GetParam() == Method::implicit_euler ? 160 : 80) << i;
        errors[i] = rms_distance(run(model, params, start, 1).state, exact);
    }
    const double order = GetParam() == Method::implicit_euler ? 1 : 2;
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), order, 0.15) << errors[0] << " " << errors[1] << " " << errors[2];
    // A12: backward Euler at 1.25 ms is 1e-3 m off, implicit midpoint 2e-5.
    EXPECT_LT(errors[0], GetParam() == Method::implicit_euler ? 2e-3 : 2e-4);
}

// One spring and a mass, W = omega h (accuracy.md A2): a step of backward Euler multiplies the amplitude by
// (1 + W^2)^(-1/2); of SDIRK2 by |R(i W)|, R(z) = (1 + (1 - 2 g) z) / (1 - g z)^2, g = 1 - 1 / sqrt(2).
TEST_P(ImplicitTest, an_oscillator_is_damped_as_the_stability_function_says)
{
    SheetSource source;
    source.mesh.positions = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}};
    source.mesh.uvs.resize(3);
    source.mesh.faces = {{0, 1, 2}};
    source.pins = {0, 1};
    source.start = source.mesh.positions;
    source.start[2].x += 1e-4f;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    SimParams params = implicit_params(GetParam());
    params.damping = params.gravity_y = 0;
    params.structural_stiffness = 100;
    params.tolerance = 1e-12f;
    const double omega = std::sqrt(100 / (double(model.areas[2]) * double(params.areal_density)));
    params.frame_rate = static_cast<int>(std::lround(omega / 0.5));
    const double w = omega / params.frame_rate, g = 1 - std::sqrt(0.5);
    const double growth = GetParam() == Method::implicit_euler ? 1 / std::sqrt(1 + w * w)
                                                               : std::hypot(1.0, (1 - 2 * g) * w) / (1 + g * g * w * w);
    constexpr int steps = 20;
    const ClothState end = run(model, params, start_state(model, params), steps).state;
    const double amplitude =
        std::hypot(double(end.positions[2].x), double(end.velocities[2].x) / omega) / double(source.start[2].x);
    EXPECT_NEAR(std::pow(amplitude, 1.0 / steps), growth, 2e-4);
}

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
        const Outcome end = run(model, params, start_state(model, params), side > 100 ? 4 : 20);
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
        const Outcome grid = run(model, params, start, 20), other = run(mesh, params, start, 20);
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
    const Outcome held = run(model, params, start, 10);
    for (std::size_t i = 1; i < start.positions.size(); ++i) EXPECT_EQ(held.state.positions[i], start.positions[i]);
    EXPECT_LT(held.state.positions[0].y, start.positions[0].y);

    start = start_state(model, params);
    const Outcome free = run(model, params, start, 30);
    const double fall = GetParam() == Method::implicit_euler ? 0.5 * 9.81 * 0.25 * (1 + 1.0 / 30) : 0.5 * 9.81 * 0.25;
    for (std::size_t i = 0; i < start.positions.size(); ++i)
        EXPECT_NEAR(double(start.positions[i].y - free.state.positions[i].y), fall, 2e-3 * fall);
}

// A limp strip that hangs by its top row in steady wind U is straight, at an angle th to the vertical of
// sin th / cos^2 th = q = rho Cn U^2 / (2 sigma g) (accuracy.md A10): 28.30 degrees at 1 m/s.
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
    const Outcome end = run(model, params, start_state(model, params), 600);
    const glm::vec4 tip = end.state.positions.back();
    EXPECT_NEAR(std::atan2(double(tip.z), -double(tip.y)) * 180 / std::acos(-1.0), 28.30, 0.5);
}

TEST_P(ImplicitTest, extremes_stay_finite)
{
    const ClothModel model = square_cloth(20, 1, {0, 19});
    for (const float scale : {1e-3f, 1.0f, 1e3f, 1e4f})
        for (const int frame_rate : {15, 60}) {
            SimParams params = implicit_params(GetParam());
            params.frame_rate = frame_rate;
            params.structural_stiffness *= scale;
            params.shear_stiffness *= scale;
            params.bend_stiffness *= scale;
            ClothState start = start_state(model, params);
            for (std::size_t i = 0; i < start.velocities.size(); i += 3) start.velocities[i].z = 1e3f;
            const Outcome end = run(model, params, start, 20);
            for (const glm::vec4& p : end.state.positions) {
                ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
                    << scale << " " << frame_rate;
                ASSERT_LT(glm::length(glm::vec3(p)), 1e4f) << scale << " " << frame_rate;
            }
        }
}

class ImplicitThreadsTest : public ImplicitTest
{};
INSTANTIATE_TEST_SUITE_P(methods, ImplicitThreadsTest, testing::Values(Method::implicit_euler, Method::sdirk2),
                         [](const auto& each) { return std::string(choice_names(Method{})[std::size_t(each.param)]); });

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
        const std::uint64_t one = state_hash(run(model, params, start, 2, 1).state);
        for (const int threads : {2, 3}) EXPECT_EQ(state_hash(run(model, params, start, 2, threads).state), one);
    }
}

}  // namespace
}  // namespace nuno
