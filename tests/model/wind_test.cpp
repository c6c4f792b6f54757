// Moving air: gusts, and the force on a face.
#include "model/wind_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/formulas.h"
#include "support/verification.h"

namespace nuno {
namespace {

namespace f = formulas_f64;

SimParams gusty()
{
    SimParams params;
    params.wind_x = 3;
    params.wind_z = -1;
    params.gust_speed = 2;
    params.gust_size = 0.5f;
    params.gust_seed = 11;
    return params;
}

TEST(WindField, gusts_stay_within_their_speed_and_average_to_nothing)
{
    const SimParams params = gusty();
    const AirField field = air_field(params, 0);
    glm::dvec3 mean(0), square(0);
    constexpr int count = 30000;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> at(-30, 30);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 gust = air_velocity(field, {at(random), at(random), at(random)}) - glm::dvec3(3, 0, -1);
        for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(gust[axis]), 2.0001);
        mean += gust / double(count);
        square += gust * gust / double(count);
    }
    // Lattice numbers have variance 1/3; blending with w and 1 - w along three axes leaves E[w^2 + (1 - w)^2]^3 of it,
    // for t^3 (6 t^2 - 15 t + 10) the integral is 181/231.
    const double rms = 2 * std::sqrt(std::pow(181.0 / 231.0, 3) / 3);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(mean[axis], 0, 5 * rms / std::sqrt(count));
        expect_measured("gusts: rms of a component over its largest, m/s", std::sqrt(square[axis]), rms, 0.03 * rms);
    }
}

TEST(WindField, the_mean_wind_carries_the_gusts_along)
{
    const SimParams params = gusty();
    const glm::dvec3 x(0.3, -0.7, 1.1), wind(3, 0, -1);
    for (const double time_s : {0.4, 7.0, 1234.5}) {
        const glm::dvec3 then = air_velocity(air_field(params, time_s), x + wind * time_s);
        EXPECT_LE(glm::distance(then, air_velocity(air_field(params, 0), x)), 1e-3) << time_s;
    }
}

TEST(WindField, is_smooth_and_repeats_for_one_seed_only)
{
    SimParams params = gusty();
    const AirField field = air_field(params, 2);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 x(0.01 * i, -0.003 * i, 0.5);
        // Blending changes by at most 15/8 a cell, numbers by 2.
        EXPECT_LE(glm::distance(air_velocity(field, x), air_velocity(field, x + glm::dvec3(1e-4, 0, 0))),
                  2 * 2 * 1.875 / 0.5 * 1e-4 * std::sqrt(3.0));
    }
    const glm::dvec3 here = air_velocity(field, {1, 2, 3});
    EXPECT_EQ(air_velocity(air_field(params, 2), {1, 2, 3}), here);
    params.gust_seed = 12;
    EXPECT_NE(air_velocity(air_field(params, 2), {1, 2, 3}), here);
}

TEST(Gusts, every_lane_is_the_scalar_formula_bit_for_bit)
{
    std::mt19937 random(3);
    std::normal_distribution<float> at(0, 300);
    for (int round = 0; round < 200; ++round) {
        float q[3][kLanes], out[3][kLanes];
        for (auto& axis : q)
            for (float& value : axis) value = at(random);
        const WideVec3 gust =
            formulas_wide::gust_at({WideFloat(q[0]), WideFloat(q[1]), WideFloat(q[2])}, formulas_wide::Bits{} + 77u);
        gust.x.store(out[0]), gust.y.store(out[1]), gust.z.store(out[2]);
        for (int lane = 0; lane < kLanes; ++lane)
            EXPECT_EQ(formulas::gust_at({q[0][lane], q[1][lane], q[2][lane]}, 77u),
                      glm::vec3(out[0][lane], out[1][lane], out[2][lane]));
    }
}

// F = rho A / 2 (Cn |u.n| (u.n) n + Ct |u| u_t).
TEST(FaceAirForce, is_the_quasi_steady_law)
{
    const f::Air air{1.2, 2, 0.1, 0.2, 0};
    const glm::dvec3 e1(0.3, 0, 0), e2(0.1, 0.4, 0), u(2, -1, 3);
    const double area = 0.06;
    const glm::dvec3 expected =
        0.5 * 1.2 * area * (2.0 * 3 * 3 * glm::dvec3(0, 0, 1) + 0.1 * glm::length(u) * glm::dvec3(2, -1, 0));
    EXPECT_LE(glm::distance(f::face_air_force(e1, e2, u, area, air), expected), 1e-15);
    EXPECT_LE(glm::distance(f::face_air_force(e2, e1, u, area, air), expected), 1e-15) << "either side alike";
    EXPECT_EQ(f::face_air_force(e1, 2.0 * e1, u, 0, air), glm::dvec3(0)) << "no area";
}

// A damper that in one substep takes at most half of the speed cannot turn it round, however long the substep.
TEST(FaceAirForce, never_takes_more_than_half_of_the_speed_in_a_substep)
{
    const glm::dvec3 e1(0.1, 0, 0), e2(0, 0.1, 0);
    const double area = 0.005, sigma = 0.2;
    for (const double h : {1e-5, 1e-3, 1e-1})
        for (const double speed : {0.1, 10.0, 100.0, 300.0}) {
            const glm::dvec3 u = speed * glm::normalize(glm::dvec3(1, 0, 2));
            const glm::dvec3 change = h / (sigma * area) * f::face_air_force(e1, e2, u, area, {1.2, 2, 50, sigma, h});
            EXPECT_LE(change.z, 0.5000001 * u.z);
            EXPECT_LE(change.x, 0.5000001 * u.x);
            EXPECT_GT(change.z, 0);
        }
}

}  // namespace
}  // namespace nuno
