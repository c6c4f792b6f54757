// The accelerations that solvers find, against the plain sum of forces in double; and faces that have hardly a shape.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/force_model.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

SimParams with_all_forces(InternalModel internal)
{
    SimParams params = on_cpu(Method::explicit_euler);
    params.internal_model = internal;
    params.warp_stiffness = 300;
    params.cross_stiffness = 60;
    params.bending_warp = 1e-3f;
    params.bending_weft = 2e-3f;
    params.bending_bias = 2e-3f;
    params.stiffness_damping = 1e-2f;
    params.wind_model = WindModel::aero;
    params.wind_x = 3;
    params.wind_z = 7;
    params.gust_speed = 4;
    params.gust_size = 0.3f;
    params.skin_coefficient = 0.5f;
    // So short a substep that the force of the air is not bounded.
    params.frame_rate = 1000;
    params.substeps = 10;
    return params;
}

ClothState shaken(const ClothModel& model, const SimParams& params)
{
    ClothState state = start_state(model, params);
    std::mt19937 random(8);
    std::normal_distribution<float> at(0, 1);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        state.positions[v] += glm::vec4(0.02f * at(random), 0.02f * at(random), 0.05f * at(random), 0);
        state.velocities[v] += glm::vec4(at(random), at(random), at(random), 0);
    }
    return state;
}

// Explicit Euler's first substep: a = (v1 - v0) / h. The change of speed is known to a few ulp of the speed.
TEST(Forces, of_a_shaken_cloth_are_those_of_the_plain_sum)
{
    for (const SheetSource& source : {square_sheet(9, 1), square_mesh(8, 1)})
        for (const InternalModel internal :
             {InternalModel::springs, InternalModel::fabric_springs, InternalModel::continuum}) {
            const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
            const SimParams params = with_all_forces(internal);
            const ClothState start = shaken(model, params), end = run(model, params, start, 1);
            std::vector<glm::dvec3> x, v, force(start.positions.size());
            for (const glm::vec4& p : start.positions) x.emplace_back(p);
            for (const glm::vec4& u : start.velocities) v.emplace_back(u);
            ForceModel(model, params).forces(x, v, 0, force);
            const double h = double(substep_s(params));
            double largest = 0;
            for (std::size_t i = 0; i < x.size(); ++i)
                largest = std::max(largest, glm::length(force[i]) * double(start.positions[i].w));
            for (std::size_t i = 0; i < x.size(); ++i) {
                const glm::dvec3 expected = force[i] * double(start.positions[i].w);
                const glm::dvec3 found = (glm::dvec3(end.velocities[i]) - v[i]) / h;
                EXPECT_LE(glm::distance(found, expected), 1e-5 * largest + 4e-7 * glm::length(v[i]) / h) << i;
            }
        }
}

// A sliver whose height is a millionth of its length, a face that is folded to a line, and one to a point.
TEST(Forces, stay_finite_on_slivers_and_collapsed_faces)
{
    SheetSource source;
    source.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-6f, 0}, {0.5f, -1, 0}, {1, -1, 0}};
    source.mesh.uvs.resize(5);
    source.mesh.faces = {{0, 2, 1}, {0, 3, 1}, {1, 3, 4}};
    source.start = {{0, 0, 0}, {1, 0, 0}, {0.5f, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    for (const InternalModel internal : {InternalModel::fabric_springs, InternalModel::continuum}) {
        SimParams params = with_all_forces(internal);
        params.bending_warp = params.bending_weft = params.bending_bias = 0;
        params.method = Method::symplectic_euler;
        params.damping = 10;
        params.stiffness_damping = 0;
        const ClothState end = run(model, params, start_state(model, params), 2000);
        EXPECT_EQ(first_lost(end.positions), std::nullopt);
        EXPECT_EQ(first_lost(end.velocities), std::nullopt);
    }
}

}  // namespace
}  // namespace nuno
