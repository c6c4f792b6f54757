// The predicted stability limits.
#include "model/stability.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/sheets.h"
#include "support/verification.h"

namespace nuno {
namespace {

SimParams grid_of_a3()
{
    SimParams params;
    params.structural_stiffness = 50;
    params.shear_stiffness = 25;
    params.bend_stiffness = 10;
    params.damping = 0;
    params.areal_density = 0.072f;  // 5e-4 kg for each of 12 x 12 vertices on 1 m2
    return params;
}

// omega h up to which a method is stable at the damping ratio zeta.
double limit_of(Method method, double zeta) { return stable_until(method, {1, 2 * zeta}); }

// On the seed's grid omega_max^2 <= 4 (k + ks + kb) / m, which its inner vertices attain.
TEST(Stability, the_bound_on_a_grid_is_the_closed_form)
{
    const ClothModel model = square_cloth(12, 1);
    const SimParams params = grid_of_a3();
    const double mass = double(model.areas[0]) * double(params.areal_density);
    EXPECT_NEAR(omega_max_bound(model, params), std::sqrt(4 * 85 / mass), 1e-4 * std::sqrt(4 * 85 / mass));
}

// The eigenvalue problem of the whole matrix M^-1 K, solved once: 768.57 rad/s; the bound is 2 sqrt(85 N/m / m) =
// 824.6.
TEST(Stability, power_iteration_finds_the_highest_frequency_of_the_reference_grid)
{
    const ClothModel model = square_cloth(12, 1);
    const SimParams params = grid_of_a3();
    std::vector<glm::dvec3> mode;
    const ClothState state = start_state(model, params);
    EXPECT_NEAR(omega_max(model, params, state, mode), 768.57, 0.005 * 768.57);
    for (int i = 0; i < 20; ++i) omega_max(model, params, state, mode);
    expect_measured("highest frequency of a 12 x 12 grid, rad/s", omega_max(model, params, state, mode), 768.57,
                    0.0002 * 768.57);
    expect_measured("its bound, rad/s", omega_max_bound(model, params), 824.6, 0.1);
}

TEST(Stability, the_frequency_at_a_state_stays_below_the_bound_of_membrane_and_plate)
{
    for (const MassLumping lumping : {MassLumping::equal, MassLumping::area})
        for (const SheetSource& source : {square_sheet(12, 1, {0, 11}), square_mesh(9, 1)}) {
            const ClothModel model = build_cloth_model(std::span(&source, 1), lumping);
            SimParams params;
            params.internal_model = InternalModel::continuum;
            params.cross_stiffness = 200;
            params.bending_warp = params.bending_weft = params.bending_bias = 1e-3f;
            std::vector<glm::dvec3> mode;
            const double found = omega_max(model, params, start_state(model, params), mode);
            const double bound = omega_max_bound(model, params);
            EXPECT_LE(found, bound);
            EXPECT_GE(found, 0.6 * bound);
        }
}

// The smallest omega h that is no longer stable, from the matrix of a substep (Hairer and Wanner, Solving ODEs II,
// IV.2):
//     explicit Euler 2 z, past z = 1 2 / (z + sqrt(z^2 - 1)); symplectic Euler 2 (sqrt(1 + z^2) - z); Runge's method
//     where |1 + w + w^2/2 + w^3/6 + w^4/24| = 1 on the ray of w = h (-z +- sqrt(z^2 - 1)).
TEST(Oscillator, limits_are_those_of_the_reference_table)
{
    const double zetas[] = {0.01, 0.1, 0.5, 1, 2};
    const double rk4[] = {2.848, 2.95, 2.62, 2.785, 0.75};
    for (int i = 0; i < 5; ++i) {
        const double z = zetas[i];
        const auto what = [&](Method method) {
            return fmt::format("limit of an oscillator, {}, zeta {}: omega h",
                               choice_names(method)[std::size_t(method)], z);
        };
        const auto expect_limit = [&](Method method, double expected, double tolerance) {
            expect_measured(what(method), limit_of(method, z), expected, tolerance);
        };
        expect_limit(Method::explicit_euler, z <= 1 ? 2 * z : 2 / (z + std::sqrt(z * z - 1)), 1e-6);
        expect_limit(Method::symplectic_euler, 2 * (std::sqrt(1 + z * z) - z), 1e-6);
        expect_limit(Method::rk4, rk4[i], 6e-3);
    }
    EXPECT_EQ(limit_of(Method::explicit_euler, 0), 0);
    EXPECT_NEAR(limit_of(Method::symplectic_euler, 0), 2, 1e-5);
    EXPECT_NEAR(limit_of(Method::verlet, 0), 2, 1e-5);
    EXPECT_NEAR(limit_of(Method::rk4, 0), 2 * std::sqrt(2.0), 1e-5);
}

// A damper alone, rate h: (1 - s/2) of verlet's predicted velocity makes its polynomial z^2 - (1 - 3 s/2) z - s/2.
TEST(Oscillator, a_damper_alone_has_the_limit_of_its_polynomial)
{
    EXPECT_NEAR(stable_until(Method::verlet, {0, 1}), 1, 1e-6);
    EXPECT_NEAR(stable_until(Method::explicit_euler, {0, 1}), 2, 1e-6);
    EXPECT_NEAR(stable_until(Method::symplectic_euler, {0, 1}), 2, 1e-6);
    EXPECT_NEAR(stable_until(Method::rk4, {0, 1}), 2.7853, 1e-4);
}

TEST(Stability, explicit_euler_without_damping_is_never_stable)
{
    const ClothModel model = square_cloth(5, 1);
    SimParams params;
    params.method = Method::explicit_euler;
    params.damping = 0;
    EXPECT_EQ(largest_stable_substep(model, params), 0);
    EXPECT_EQ(least_stable_substeps(model, params), 0);
}

TEST(Stability, damping_lowers_the_symplectic_limit_and_raises_the_explicit_one)
{
    const ClothModel model = square_cloth(9, 1);
    SimParams weak, strong;
    weak.method = strong.method = Method::symplectic_euler;
    weak.damping = 0.01f;
    strong.damping = 5;
    EXPECT_LT(largest_stable_substep(model, strong), largest_stable_substep(model, weak));
    weak.method = strong.method = Method::explicit_euler;
    EXPECT_GT(largest_stable_substep(model, strong), largest_stable_substep(model, weak));
}

// Rayleigh damping that calms slow folds is a strong damper of the fastest mode: zeta = beta omega / 2.
TEST(Stability, rayleigh_damping_lowers_the_limit_as_its_damping_ratio_says)
{
    SimParams params;
    params.method = Method::symplectic_euler;
    params.damping = 0;
    params.stiffness_damping = 0.004f;
    const double omega = 500, zeta = 1;
    EXPECT_NEAR(largest_stable_substep(params, omega), 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega, 1e-8);
}

TEST(Stability, the_present_state_asks_for_more_substeps_once_the_cloth_is_stretched)
{
    const ClothModel model = square_cloth(12, 1);
    SimParams params = grid_of_a3();
    params.method = Method::symplectic_euler;
    ClothState state = start_state(model, params);
    std::vector<glm::dvec3> mode;
    const PresentStability at_rest = present_stability(model, params, state, mode);
    for (glm::vec4& p : state.positions) p = glm::vec4(2.0f * glm::vec3(p), p.w);
    const PresentStability stretched = present_stability(model, params, state, mode);
    EXPECT_GT(stretched.omega_max, at_rest.omega_max);
    EXPECT_LE(stretched.omega_max, std::sqrt(1.5) * at_rest.omega_bound);
    EXPECT_GT(stretched.least_substeps, at_rest.least_substeps);
    EXPECT_NEAR(at_rest.largest_stable_substep_s, 2 / at_rest.omega_max, 1e-8);
}

}  // namespace
}  // namespace nuno
