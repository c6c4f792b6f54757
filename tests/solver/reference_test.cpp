// The reference method against closed forms, and against itself at other tolerances.
#include "solver/explicit/cpu_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

SimParams reference_params()
{
    SimParams params = on_cpu(Method::reference);
    params.frame_rate = 60;
    return params;
}

ClothState run_frames(const ClothModel& model, const SimParams& params, int frames, long* steps = nullptr)
{
    ThreadPool pool(1);
    CpuReference solver(model, kNoBodies, params, pool);
    solver.upload(start_state(model, params));
    for (int frame = 0; frame < frames; ++frame)
        solver.step({params, frame / double(params.frame_rate), params.substeps});
    if (steps) *steps = solver.step_count();
    return state_of(solver, model);
}

// y(t) = (m g / c) (t - (m / c) (1 - e^(-c t / m))): to the rounding of floats.
TEST(Reference, free_fall_with_drag_follows_the_closed_form)
{
    const ClothModel model = square_cloth(4, 1);
    SimParams params = reference_params();
    params.damping = 0.3f;
    const double rate = double(params.damping) / double(params.areal_density), g = double(params.gravity_y), t = 1;
    const double fall = g / rate * (t - (1 - std::exp(-rate * t)) / rate);
    const ClothState start = start_state(model, params), end = run_frames(model, params, 60);
    for (const std::size_t i : {0, 5, 15})
        expect_measured("way of a fall with drag, reference: m",
                        double(end.positions[i].y) - double(start.positions[i].y), fall, 1e-6);
}

// A tolerance a hundred times smaller moves nothing that a float shows much of: the default is converged.
TEST(Reference, the_default_tolerance_is_converged)
{
    const ClothModel model = square_cloth(10, 0.5f, {0, 9});
    SimParams params = reference_params();
    params.bend_stiffness = 8;
    params.gravity_z = 1;
    long steps = 0, finer_steps = 0;
    const ClothState usual = run_frames(model, params, 12, &steps);
    params.tolerance = static_cast<float>(CpuReference::kOwnTolerance / 100);
    const ClothState finer = run_frames(model, params, 12, &finer_steps);
    EXPECT_LT(largest_distance(usual, finer), 1e-6);
    EXPECT_GT(finer_steps, steps);
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
    ASSERT_EQ(solver.first_lost(), std::nullopt);
    float lowest = 0;
    for (const glm::vec4& p : state.positions) {
        EXPECT_GT(glm::distance(glm::vec3(p), bodies.spheres[0].centre), 0.3f + 0.9f * params.thickness);
        lowest = std::min(lowest, p.y);
    }
    EXPECT_LT(lowest, -0.2f);
}

}  // namespace
}  // namespace nuno
