// The plain sum of forces against its own energy, and its differential against the stiffness product.
#include "model/force_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/stiffness_product.h"
#include "support/sheets.h"

namespace nuno {
namespace {

std::vector<glm::dvec3> shaken(const ClothModel& model, double size, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return (double(random()) / 4294967295.0 * 2 - 1) * size; };
    std::vector<glm::dvec3> x;
    for (const glm::vec3& p : model.rest_positions)
        x.push_back(glm::dvec3(p) + glm::dvec3(number(), number(), number()));
    return x;
}

SimParams with_everything_elastic(InternalModel internal)
{
    SimParams params;
    params.internal_model = internal;
    params.damping = 0;
    params.warp_stiffness = 700;
    params.cross_stiffness = 60;
    params.bending_warp = 1e-3f;
    params.bending_weft = 2e-3f;
    params.bending_bias = 1e-3f;
    return params;
}

class ForceModelTest : public testing::TestWithParam<InternalModel>
{};

// force = - dE/dx, by central differences of step e: error of order e^2.
TEST_P(ForceModelTest, force_is_minus_the_gradient_of_the_energy)
{
    const ClothModel model = square_cloth(5, 1);
    const ForceModel forces(model, with_everything_elastic(GetParam()));
    std::vector<glm::dvec3> x = shaken(model, 0.05, 3);
    const std::vector<glm::dvec3> still(x.size(), glm::dvec3(0));
    std::vector<glm::dvec3> force(x.size());
    forces.forces(x, still, 0, force);
    constexpr double e = 1e-5;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const double at = x[i][k];
            x[i][k] = at + e;
            const double above = forces.potential_energy(x);
            x[i][k] = at - e;
            const double below = forces.potential_energy(x);
            x[i][k] = at;
            EXPECT_NEAR(force[i][k], (below - above) / (2 * e), 1e-5 * (1 + std::abs(force[i][k])));
        }
}

// K u = - d force / dx . u.
TEST_P(ForceModelTest, stiffness_product_is_minus_the_differential_of_the_force)
{
    const ClothModel model = square_cloth(6, 1);
    const SimParams params = with_everything_elastic(GetParam());
    const ForceModel forces(model, params);
    const std::vector<glm::dvec3> moved = shaken(model, 0.05, 5), u = shaken(model, 1, 7);
    std::vector<glm::vec4> state;
    std::vector<glm::dvec3> x, still(u.size(), glm::dvec3(0)), above(u.size()), below(u.size()), product(u.size());
    for (const glm::dvec3& p : moved) {
        state.emplace_back(glm::vec3(p), 1.0f);
        x.emplace_back(glm::vec3(state.back()));
    }
    StiffnessProduct(model, params).multiply(state, u, product);
    constexpr double e = 1e-6;
    std::vector<glm::dvec3> y = x;
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] + e * u[i];
    forces.forces(y, still, 0, above);
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] - e * u[i];
    forces.forces(y, still, 0, below);
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(product[i][k], (below[i][k] - above[i][k]) / (2 * e), 1e-5 * (1 + std::abs(product[i][k])));
}

// Internal forces cannot push or turn a cloth as a whole, and do not act on one that has only turned.
TEST_P(ForceModelTest, a_turned_cloth_feels_no_force_and_a_shaken_one_none_as_a_whole)
{
    const ClothModel model = square_cloth(5, 1);
    SimParams params = with_everything_elastic(GetParam());
    params.stiffness_damping = 0.01f;
    params.gravity_y = 0;
    const ForceModel forces(model, params);
    std::vector<glm::dvec3> turned, force(model.vertex_count());
    for (const glm::vec3& p : model.rest_positions)
        turned.emplace_back(0.6 * double(p.x) - 0.8 * double(p.y), 0.8 * double(p.x) + 0.6 * double(p.y),
                            double(p.z) + 3);
    const std::vector<glm::dvec3> still(force.size(), glm::dvec3(0));
    forces.forces(turned, still, 0, force);
    for (const glm::dvec3& f : force)
        EXPECT_LT(glm::length(f), 1e-3);  // rest lengths are floats: 700 N/m 1e-7 m a spring

    const std::vector<glm::dvec3> x = shaken(model, 0.05, 9), v = shaken(model, 1, 11);
    forces.forces(x, v, 0, force);
    glm::dvec3 sum(0), torque(0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum += force[i];
        torque += glm::cross(x[i], force[i]);
    }
    EXPECT_LT(glm::length(sum), 1e-10);
    EXPECT_LT(glm::length(torque), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(models, ForceModelTest,
                         testing::Values(InternalModel::springs, InternalModel::fabric_springs,
                                         InternalModel::continuum),
                         [](const auto& each) {
                             return std::string(choice_names(InternalModel{})[std::size_t(each.param)]);
                         });

// Terminal speed of a flat cloth that falls face on: sqrt(2 sigma g / (rho Cn)).
TEST(ForceModel, air_carries_a_flat_cloth_at_its_terminal_speed)
{
    SheetSource source = square_sheet(5, 1);
    source.mesh = grid_mesh(5, 5, {0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    SimParams params;
    params.damping = 0;
    params.wind_model = WindModel::aero;
    const ForceModel forces(model, params);
    const double speed =
        std::sqrt(2 * double(params.areal_density) * 9.81 / double(params.air_density * params.pressure_coefficient));
    const std::vector<glm::dvec3> x(model.rest_positions.begin(), model.rest_positions.end());
    const std::vector<glm::dvec3> v(x.size(), glm::dvec3(0, -speed, 0));
    std::vector<glm::dvec3> force(x.size());
    forces.forces(x, v, 0, force);
    for (std::uint32_t i = 0; i < force.size(); ++i) EXPECT_LT(glm::length(force[i]), 1e-5 * 9.81 * forces.mass(i));
}

}  // namespace
}  // namespace nuno
