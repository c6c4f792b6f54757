// What sets the two Euler methods apart from the others.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/explicit_runs.h"

namespace nuno {
namespace {

// Along y the two springs act as k_eff = 2 k (depth / length)^2; symplectic Euler oscillates at (2 / h) asin(omega h /
// 2) (accuracy A2).
TEST(SymplecticEuler, a_mass_on_springs_swings_with_the_period_of_theory)
{
    const float half_width = 0.3f, depth = 0.4f;
    const ClothModel model = pendulum_triangle(half_width, depth);
    SimParams params = on_cpu(Method::symplectic_euler);
    params.structural_stiffness = 20;
    params.gravity_y = params.damping = 0;
    params.substeps = 2000;
    const double h = double(substep_s(params)), mass = double(model.areas[2]) * 0.2;
    const double omega = std::sqrt(2 * 20 * 0.64 / mass), period = 2 * M_PI / (2 / h * std::asin(omega * h / 2));
    ClothState state = start_state(model, params);
    const float rest = state.positions[2].y;
    state.positions[2].y -= 1e-3f;
    int crossings = 0;
    double last = 0, first = 0;
    for (int step = 1; crossings < 41; ++step) {
        const float before = state.positions[2].y - rest;
        state = run(model, params, state, 1);
        const float after = state.positions[2].y - rest;
        if ((before < 0) == (after < 0)) continue;
        last = (step - double(after) / double(after - before)) * h;
        if (crossings++ == 0) first = last;
    }
    // 40 crossings are 20 periods. The spring's third-order term shortens them by less than (1e-3 / 0.5)^2.
    EXPECT_NEAR((last - first) / 20, period, 2e-4 * period);
}

// Explicit Euler multiplies the amplitude by sqrt(1 + (omega h)^2) each substep (accuracy A2: |lambda|^2 = 1 + W^2).
TEST(ExplicitEuler, undamped_it_gains_energy_as_theory_says)
{
    const ClothModel model = pendulum_triangle(0.3f, 0.4f);
    SimParams params = on_cpu(Method::explicit_euler);
    params.structural_stiffness = 20;
    params.gravity_y = params.damping = 0;
    params.substeps = 1000;
    const double h = double(substep_s(params)), mass = double(model.areas[2]) * 0.2, k = 2 * 20 * 0.64;
    const double w = std::sqrt(k / mass) * h;
    ClothState state = start_state(model, params);
    const double rest = double(state.positions[2].y);
    state.positions[2].y += 1e-4f;
    const auto energy = [&](const ClothState& s) {
        const double y = double(s.positions[2].y) - rest, v = double(s.velocities[2].y);
        return 0.5 * k * y * y + 0.5 * mass * v * v;
    };
    const double before = energy(state);
    const double after = energy(run(model, params, state, 300));
    EXPECT_NEAR(std::log(after / before), 300 * std::log1p(w * w), 0.02 * 300 * std::log1p(w * w));
}

}  // namespace
}  // namespace nuno
