// The shared formulas against their equations.
#include "model/formulas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// f = k (|d| - l0) d / |d| (seed paper, 2.2.1), in double.
glm::dvec3 hooke(glm::dvec3 d, double rest_length, double stiffness)
{
    return stiffness * (glm::length(d) - rest_length) / glm::length(d) * d;
}

TEST(SpringForce, is_hookes_law)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> at(-2, 2);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 d(at(random), at(random), at(random));
        const float rest_length = 0.1f + std::abs(at(random)), stiffness = 100 * std::abs(at(random));
        const glm::dvec3 expected = hooke(d, rest_length, stiffness);
        const glm::vec3 force = formulas::spring_force(d, stiffness, stiffness * rest_length);
        // Three roundings in the length, one each in difference, product and quotient: 8 ulp of the larger part.
        const double tolerance = 8 * 6e-8 * stiffness * (double(glm::length(d)) + double(rest_length));
        EXPECT_LE(glm::distance(glm::dvec3(force), expected), tolerance);
    }
}

TEST(SpringForce, is_zero_at_rest_and_where_there_is_no_direction)
{
    EXPECT_EQ(formulas::spring_force({0, 3, 4}, 100, 500), glm::vec3(0));
    const glm::vec3 none = formulas::spring_force({0, 0, 0}, 1e6f, 1e6f);
    EXPECT_TRUE(none == glm::vec3(0)) << none.x;
    const glm::vec3 tiny = formulas::spring_force({1e-30f, 0, 0}, 1e6f, 1e6f);
    EXPECT_TRUE(std::isfinite(tiny.x) && std::isfinite(tiny.y));
}

TEST(Wind, is_the_seeds_product_of_sines)
{
    // alpha sin(100 t / 85) sin(100 t / 65)
    for (const double t : {0.0, 0.3, 1.0, 7.5})
        EXPECT_NEAR(formulas_f64::sines_wind(2.5, t), 2.5 * std::sin(100 * t / 85) * std::sin(100 * t / 65), 1e-14);
}

TEST(Acceleration, sums_gravity_damper_springs_and_wind_over_the_mass)
{
    const double mass = 0.5, rho = 0.2;
    const glm::dvec3 g(0, -9.81, 1), v(1, 2, 3), springs(4, -5, 6);
    const glm::dvec3 expected = (mass * g - rho * v + springs + glm::dvec3(0, 0, 0.7)) / mass;
    const glm::dvec3 a = formulas_f64::acceleration(1 / mass, mass, g, rho, v, springs, 0.7);
    EXPECT_LE(glm::distance(a, expected), 1e-14);
    EXPECT_EQ(formulas_f64::acceleration(0, mass, g, rho, v, springs, 0.7), glm::dvec3(0)) << "pinned";
}

TEST(Euler, the_seeds_takes_both_updates_from_the_old_state)
{
    const auto m = formulas_f64::explicit_euler({1, 0, 0}, {2, 0, 0}, {3, 0, 0}, 0.5);
    EXPECT_EQ(m.velocity.x, 2 + 3 * 0.5);
    EXPECT_EQ(m.position.x, 1 + 2 * 0.5);
}

TEST(Euler, the_symplectic_one_moves_with_the_new_velocity)
{
    const auto m = formulas_f64::symplectic_euler({1, 0, 0}, {2, 0, 0}, {3, 0, 0}, 0.5);
    EXPECT_EQ(m.velocity.x, 3.5);
    EXPECT_EQ(m.position.x, 1 + 3.5 * 0.5);
}

TEST(Wide, every_lane_is_the_scalar_formula_bit_for_bit)
{
    std::mt19937 random(3);
    std::normal_distribution<float> at(0, 1);
    for (int round = 0; round < 200; ++round) {
        float x[3][kLanes], v[3][kLanes], out[3][kLanes];
        for (int c = 0; c < 3; ++c)
            for (int lane = 0; lane < kLanes; ++lane) x[c][lane] = at(random), v[c][lane] = at(random);
        const WideVec3 wx{WideFloat(x[0]), WideFloat(x[1]), WideFloat(x[2])};
        const WideVec3 wv{WideFloat(v[0]), WideFloat(v[1]), WideFloat(v[2])};
        const WideVec3 force = formulas_wide::spring_force(wx, WideFloat(0.7f), WideFloat(33.0f));
        const auto surface = formulas_wide::sphere_surface(wx, WideFloat(1.0f), WideVec3(0.1f));
        const auto held = formulas_wide::push_out(WideVec3(0.2f), formulas_wide::motion(wx, wv), surface,
                                                  WideVec3(0.1f), {WideFloat(0.3f), WideFloat(0.4f)}, WideFloat(0.01f))
                              .motion;
        const WideVec3 sum = force + held.position + held.velocity;
        sum.x.store(out[0]), sum.y.store(out[1]), sum.z.store(out[2]);
        for (int lane = 0; lane < kLanes; ++lane) {
            const glm::vec3 p(x[0][lane], x[1][lane], x[2][lane]), u(v[0][lane], v[1][lane], v[2][lane]);
            const auto m = formulas::push_out(glm::vec3(0.2f), {p, u}, formulas::sphere_surface(p, 1, glm::vec3(0.1f)),
                                              glm::vec3(0.1f), {0.3f, 0.4f}, 0.01f)
                               .motion;
            const glm::vec3 expected = formulas::spring_force(p, 0.7f, 33) + m.position + m.velocity;
            EXPECT_EQ(expected, glm::vec3(out[0][lane], out[1][lane], out[2][lane]));
        }
    }
}

}  // namespace
}  // namespace nuno
