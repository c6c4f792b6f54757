// Cloth without pins that lies over a body, tethered to what sticks to it: it comes to rest, and stretches less.
#include <gtest/gtest.h>

#include "model/diagnostics.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

SimParams draped(Tethers tethers, int substeps, float drag, float friction)
{
    SimParams params = on_cpu(Method::xpbd, Sweep::rows);
    params.frame_rate = 60;
    params.substeps = substeps;
    params.tethers = tethers;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = drag * params.areal_density;
    params.friction = params.static_friction = friction;
    params.thickness = 0;
    return params;
}

// A level sheet of 2 m, whose middle is at 0, 0, 1, let go.
Diagnostics dropped(int count, const Bodies& bodies, const SimParams& params, int frame_count)
{
    SheetSource source;
    source.mesh = grid_mesh(count, count, {-1, 0, 0}, {2, 0, 0}, {0, 0, 2});
    source.columns = source.rows = count;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    ThreadPool pool(1);
    const auto solver = make_solver(model, bodies, params, pool);
    solver->upload(start_state(model, params));
    for (int frame = 0; frame < frame_count; ++frame) solver->step({params, frame / 60.0, params.substeps});
    return measure(model, state_of(*solver, model), params);
}

// What sticks changes from substep to substep, here at the rim of what touches. Whoever is tethered to something else
// than before must not be moved by that: at rest such jumps had 0.04 J of this sheet of 0.8 kg, 2 m/s.
TEST(ContactTethers, let_cloth_over_a_ball_come_to_rest)
{
    Bodies bodies;
    Sphere& ball = bodies.spheres.emplace_back();
    ball.centre = {0, -0.42f, 1};
    ball.radius = 0.4f;
    for (const Tethers tethers : {Tethers::none, Tethers::contacts}) {
        const Diagnostics end = dropped(33, bodies, draped(tethers, 5, 2, 0.3f), 300);
        EXPECT_LT(end.kinetic_j, 1e-3);
        EXPECT_LT(end.max_speed, 0.3);
    }
}

// Where the cloth hangs straight down from what sticks, tethers reach along it.
TEST(ContactTethers, hold_cloth_over_a_rail_with_less_strain)
{
    Bodies bodies;
    Capsule& rail = bodies.capsules.emplace_back();
    rail.radius = 0.1f;
    rail.from = {-1.5f, -0.11f, 1};
    rail.to = {1.5f, -0.11f, 1};
    const Diagnostics without = dropped(65, bodies, draped(Tethers::none, 3, 3, 1), 240);
    const Diagnostics with = dropped(65, bodies, draped(Tethers::contacts, 3, 3, 1), 240);
    EXPECT_GT(without.max_strain, 0.03);
    EXPECT_LT(with.max_strain, 0.6 * without.max_strain);
    EXPECT_LT(with.kinetic_j, 1e-3);
}

}  // namespace
}  // namespace nuno
