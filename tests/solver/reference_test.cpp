// The reference method against closed forms, and against itself at other tolerances.
#include "solver/explicit/cpu_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sheets.h"

namespace nuno {
namespace {

const Bodies kNoBodies;

SimParams reference_params()
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = Method::reference;
    params.substeps = 1;
    return params;
}

ClothState run(const ClothModel& model, const SimParams& params, int frames, long* steps = nullptr)
{
    ThreadPool pool(1);
    CpuReference solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    solver.upload(state);
    for (int frame = 0; frame < frames; ++frame)
        solver.step({params, frame / double(params.frame_rate), params.substeps});
    solver.download_positions(state.positions);
    solver.download_velocities(state.velocities);
    if (steps) *steps = solver.step_count();
    return state;
}

double largest_distance(const ClothState& a, const ClothState& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        largest = std::max(largest, double(glm::distance(glm::vec3(a.positions[i]), glm::vec3(b.positions[i]))));
    return largest;
}

// y(t) = (m g / c) (t - (m / c) (1 - e^(-c t / m))): to the rounding of floats.
TEST(Reference, free_fall_with_drag_follows_the_closed_form)
{
    const ClothModel model = square_cloth(4, 1);
    SimParams params = reference_params();
    params.damping = 0.3f;
    const double rate = double(params.damping) / double(params.areal_density), g = double(params.gravity_y), t = 1;
    const double fall = g / rate * (t - (1 - std::exp(-rate * t)) / rate);
    const ClothState start = start_state(model, params), end = run(model, params, 60);
    for (std::size_t i = 0; i < start.positions.size(); ++i)
        EXPECT_NEAR(double(end.positions[i].y) - double(start.positions[i].y), fall, 1e-6);
}

// A corner between two springs at right angles, k in each: T = 2 pi sqrt(m / k) for a small swing along the first.
TEST(Reference, an_oscillator_keeps_its_period_and_energy)
{
    SheetSource source;
    source.mesh.positions = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}};
    source.mesh.uvs.resize(3);
    source.mesh.faces = {{0, 1, 2}};
    source.pins = {0, 1};
    constexpr float amplitude = 1e-3f;
    source.start = source.mesh.positions;
    source.start[2].x += amplitude;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    SimParams params = reference_params();
    params.damping = 0;
    params.gravity_y = 0;
    params.structural_stiffness = 100;
    params.tolerance = 1e-6f;  // the shortest thread is a thousand amplitudes long
    const double mass = double(model.areas[2]) * double(params.areal_density);
    const double period = 2 * std::acos(-1.0) * std::sqrt(mass / 100);
    // 20 periods, to a whole frame.
    params.frame_rate = static_cast<int>(std::lround(1 / period));
    const double time = 20 * std::lround(double(params.frame_rate) * period) / double(params.frame_rate);
    const ClothState end = run(model, params, static_cast<int>(std::lround(time * params.frame_rate)));
    // The other spring turns by 1e-3, which changes the stiffness by a few 1e-6.
    const double expected = double(amplitude) * std::cos(2 * std::acos(-1.0) * time / period);
    EXPECT_NEAR(double(end.positions[2].x), expected, 1e-2 * double(amplitude));
    const double speed = 2 * std::acos(-1.0) / period;
    const double energy = std::pow(double(end.positions[2].x) * speed, 2) + std::pow(double(end.velocities[2].x), 2);
    EXPECT_NEAR(energy / std::pow(double(amplitude) * speed, 2), 1, 1e-3);
}

// A tolerance a hundred times smaller moves nothing that a float shows much of: the default is converged.
TEST(Reference, the_default_tolerance_is_converged)
{
    const ClothModel model = square_cloth(10, 0.5f, {0, 9});
    SimParams params = reference_params();
    params.bend_stiffness = 8;
    params.gravity_z = 1;
    long steps = 0, finer_steps = 0;
    const ClothState usual = run(model, params, 12, &steps);
    params.tolerance /= 100;
    const ClothState finer = run(model, params, 12, &finer_steps);
    EXPECT_LT(largest_distance(usual, finer), 1e-6);
    EXPECT_GT(finer_steps, steps);
    // Order 5: a hundredth of the error for 100^(1/5) = 2.5 times the steps.
    EXPECT_NEAR(double(finer_steps) / double(steps), 2.5, 0.8);
}

TEST(Reference, what_comes_back_from_outside_unchanged_changes_no_bit)
{
    const ClothModel model = square_cloth(8, 1, {0, 7});
    SimParams params = reference_params();
    params.gravity_z = 1;
    ClothState ends[2];
    for (const bool returns : {false, true}) {
        ThreadPool pool(1);
        CpuReference solver(model, kNoBodies, params, pool);
        ClothState state = start_state(model, params);
        solver.upload(state);
        for (int frame = 0; frame < 6; ++frame) {
            solver.step({params, frame / 60.0, 1});
            solver.download_velocities(state.velocities);
            if (returns) solver.upload_velocities(state.velocities);
        }
        solver.download_positions(state.positions);
        ends[returns] = state;
    }
    EXPECT_EQ(state_hash(ends[0]), state_hash(ends[1]));
}

TEST(Reference, a_sheet_falls_on_a_ball_and_stays_outside)
{
    SheetSource source = square_sheet(10, 1);
    source.mesh = grid_mesh(10, 10, {-0.5f, 0, -0.5f}, {1, 0, 0}, {0, 0, 1});
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    Bodies bodies;
    bodies.spheres.push_back({{0, -0.35f, 0}, 0.3f, {}});
    const SimParams params = reference_params();
    ThreadPool pool(1);
    CpuReference solver(model, bodies, params, pool);
    ClothState state = start_state(model, params);
    solver.upload(state);
    for (int frame = 0; frame < 20; ++frame) solver.step({params, frame / 60.0, 1});
    solver.download_positions(state.positions);
    ASSERT_EQ(solver.first_not_finite(), std::nullopt);
    float lowest = 0;
    for (const glm::vec4& p : state.positions) {
        EXPECT_GT(glm::distance(glm::vec3(p), bodies.spheres[0].centre), 0.3f + 0.9f * params.thickness);
        lowest = std::min(lowest, p.y);
    }
    EXPECT_LT(lowest, -0.2f);
}

}  // namespace
}  // namespace nuno
