// The predicted stability limits.
#include "model/stability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sheets.h"

namespace nuno {
namespace {

// On the seed's grid omega_max^2 <= 4 (k + ks + kb) / m, which its inner vertices attain.
TEST(Stability, the_bound_on_a_grid_is_the_closed_form)
{
    const ClothModel model = square_cloth(12, 1);
    SimParams params;
    params.structural_stiffness = 50;
    params.shear_stiffness = 25;
    params.bend_stiffness = 10;
    const double mass = double(model.areas[0]) * double(params.areal_density);
    EXPECT_NEAR(omega_max_bound(model, params), std::sqrt(4 * 85 / mass), 1e-4 * std::sqrt(4 * 85 / mass));
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
    weak.damping = 0.01f;
    strong.damping = 5;
    EXPECT_LT(largest_stable_substep(model, strong), largest_stable_substep(model, weak));
    weak.method = strong.method = Method::explicit_euler;
    EXPECT_GT(largest_stable_substep(model, strong), largest_stable_substep(model, weak));
}

}  // namespace
}  // namespace nuno
