// The verdict on one shaken cloth, and the substeps of any length that it is shaken with.
#include "study/stability_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/sheets.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr int kSeed = 1;

RestCloth sheet(double stiffness = 1, double damping = 0)
{
    SimParams params;
    params.bend_stiffness = 10;
    return rest_cloth(square_cloth(6, 1, {0, 5}), params, {.stiffness = stiffness, .damping = damping});
}

ShakeRun shaken_at(const RestCloth& cloth, Method method, double share_of_limit)
{
    const double h = share_of_limit * predicted_limit_s(cloth, Method::symplectic_euler);
    return shake(cloth, method, h, substeps_to_judge(method), kSeed);
}

TEST(StabilityRun, symplectic_euler_is_stable_before_its_limit_and_blows_up_past_it)
{
    const RestCloth cloth = sheet();
    const ShakeRun before = shaken_at(cloth, Method::symplectic_euler, 0.98);
    EXPECT_EQ(before.verdict, Verdict::stable) << before.error;
    EXPECT_EQ(before.lost_after, -1);
    EXPECT_EQ(before.substeps, substeps_to_judge(Method::symplectic_euler));
    EXPECT_EQ(shaken_at(cloth, Method::symplectic_euler, 1.02).verdict, Verdict::blown_up);
}

// With W = omega h > 2 the larger root of z^2 - (2 - W^2) z + 1 is -(q + sqrt(q^2 - 1)), q = W^2 / 2 - 1.
TEST(StabilityRun, motion_past_the_limit_grows_as_the_matrix_of_a_substep_says)
{
    const RestCloth cloth = sheet();
    for (const double share : {1.02, 1.05, 1.2}) {
        const double q = 2 * share * share - 1, growth = std::log(q + std::sqrt(q * q - 1));
        expect_measured(fmt::format("growth of symplectic Euler a substep, {} of its limit", share),
                        shaken_at(cloth, Method::symplectic_euler, share).growth, growth, 0.1 * growth);
    }
}

TEST(StabilityRun, implicit_euler_past_what_it_can_follow_is_bounded_and_wrong)
{
    const RestCloth cloth = sheet();
    EXPECT_EQ(shaken_at(cloth, Method::implicit_euler, 0.1).verdict, Verdict::stable);
    for (const double share : {10.0, 1000.0}) {
        const ShakeRun run = shaken_at(cloth, Method::implicit_euler, share);
        EXPECT_EQ(run.verdict, Verdict::wrong) << run.error;
        EXPECT_EQ(run.lost_after, -1);
    }
}

TEST(StabilityRun, undamped_explicit_euler_is_never_stable)
{
    EXPECT_EQ(shaken_at(sheet(), Method::explicit_euler, 0.1).verdict, Verdict::blown_up);
}

TEST(StabilityRun, a_number_that_is_lost_is_seen_and_growth_stays_a_number)
{
    const RestCloth cloth = sheet(1e6);
    for (const Method method : {Method::explicit_euler, Method::symplectic_euler, Method::verlet, Method::rk4}) {
        const ShakeRun run = shaken_at(cloth, method, 1e6);
        EXPECT_EQ(run.verdict, Verdict::blown_up);
        EXPECT_GE(run.lost_after, 1);
        EXPECT_TRUE(std::isfinite(run.growth));
        EXPECT_GT(run.growth, 1);
    }
}

TEST(StabilityRun, the_same_seed_gives_the_same_numbers)
{
    const RestCloth cloth = sheet(1, 5);
    const ShakeRun a = shaken_at(cloth, Method::verlet, 0.7), b = shaken_at(cloth, Method::verlet, 0.7);
    EXPECT_EQ(a.growth, b.growth);
    EXPECT_EQ(a.error, b.error);
}

// The same second in 64 substeps, once as the parameters have them and once stretched from 63.
TEST(StabilityRun, a_stretched_unit_of_time_changes_no_motion)
{
    RestCloth cloth = sheet(1, 2);
    cloth.params.gravity_y = -9.81f;
    cloth.params.stiffness_damping = 1e-4f;
    const ClothState start = shaken(cloth, {0.1, 0.3, 0, kSeed});
    ExactSubsteps whole(cloth, Method::rk4, 1.0 / 512), stretched(cloth, Method::rk4, 1.0 / 511.999);
    for (ExactSubsteps* run : {&whole, &stretched}) {
        run->upload(start);
        run->step(256);
    }
    const double moved = difference(cloth, whole.state(), cloth.rest);
    EXPECT_GT(moved, 1);
    EXPECT_LT(difference(cloth, whole.state(), stretched.state()), 1e-3 * moved);
}

TEST(StabilityRun, a_loaded_cloth_comes_to_rest_where_forces_cancel)
{
    SimParams params;
    const RestCloth cloth =
        rest_cloth(square_cloth(6, 1, {0, 5}), params, {.damping = 40, .pressure = 3, .loaded = true});
    EXPECT_LT(cloth.residual_speed, 0.01);
    ExactSubsteps run(cloth, Method::symplectic_euler, 0.5 / cloth.omega_bound);
    run.upload(cloth.rest);
    run.step(2000);
    EXPECT_LT(mean_speed(cloth, run.state()), 1e-3);
    EXPECT_GT(cloth.omega, 0);
    EXPECT_LE(cloth.omega, cloth.omega_bound);
}

}  // namespace
}  // namespace nuno
