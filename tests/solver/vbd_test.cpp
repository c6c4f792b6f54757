// Vertex block descent against backward Euler, whose energy it goes down.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/spring_weights.h"
#include "solver/solver_runs.h"
#include "solver/vbd/cpu_vbd.h"

namespace nuno {
namespace {

SimParams vbd_params(int substeps, int iterations)
{
    SimParams params = on_cpu(Method::vbd);
    params.frame_rate = 60;
    params.substeps = substeps;
    params.iterations = iterations;
    return params;
}

// Along its line the pair's length r obeys r1 = (r0 + h r0' + s l0) / (1 + s), r1' = (r1 - r0) / h, s = 2 h^2 k / m.
TEST(Vbd, one_spring_swept_to_the_end_is_backward_euler_to_rounding)
{
    ClothModel model = one_spring();
    model.pinned[0] = 0;
    SimParams params = vbd_params(1, 100);
    params.gravity_y = params.damping = 0;
    params.structural_stiffness = 1000;
    const double h = 1 / 60.0, mass = double(params.areal_density), s = 2 * h * h * 1000 / mass;
    ClothState state = start_state(model, params);
    state.positions[1].x = 1.5f;
    double r = 1.5, speed = 0;
    for (int step = 0; step < 30; ++step) {
        const double next = (r + h * speed + s) / (1 + s);
        speed = (next - r) / h;
        r = next;
        state = run(model, params, state, 1);
        // A rounding of positions, 1e-7 m, is one of 1e-7 / h in the speed; the spring damps both.
        EXPECT_NEAR(double(state.positions[1].x - state.positions[0].x), r, 2e-6) << "substep " << step;
        EXPECT_NEAR(double(state.velocities[1].x - state.velocities[0].x), speed, 1e-4) << "substep " << step;
    }
}

// At the end of a substep m (x1 - x0 - h v0) / h^2 = m g - rho v1 + springs(x1).
TEST(Vbd, enough_sweeps_solve_backward_euler_of_a_sheet)
{
    for (const bool as_mesh : {false, true}) {
        SheetSource source = as_mesh ? square_mesh(6, 1, 8) : square_sheet(6, 1);
        source.pins = {0, 5};
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        SimParams params = vbd_params(4, 300);
        params.bending_warp = params.bending_weft = params.bending_bias = 1e-3f;
        const ClothState before = run(model, params, start_state(model, params), 20);
        const ClothState after = run(model, params, before, 1);
        const double h = double(substep_s(params));
        std::vector<glm::dvec3> force(model.vertex_count(), glm::dvec3(0));
        const std::vector<SpringWeight> weights = spring_weights(model, params);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const Spring& spring = model.springs[i];
            const glm::dvec3 d = glm::dvec3(after.positions[spring.b]) - glm::dvec3(after.positions[spring.a]);
            const glm::dvec3 f = (weights[i].axial * (1 - spring.rest_length / glm::length(d)) + weights[i].plate) * d;
            force[spring.a] += f;
            force[spring.b] -= f;
        }
        for (std::uint32_t v = 0; v < model.vertex_count(); ++v) {
            if (model.pinned[v]) continue;
            const double mass = 1 / double(before.positions[v].w), area = double(model.areas[v]);
            const glm::dvec3 v0(before.velocities[v]), v1(after.velocities[v]);
            const glm::dvec3 outer = mass * glm::dvec3(0, params.gravity_y, 0) - params.damping * area * v1;
            const glm::dvec3 rest = mass * (v1 - v0) / h - outer - force[v];
            // Rounding of positions, 1e-7 m, times the sum of 12 springs of up to 40 N/m.
            EXPECT_LT(glm::length(rest), 1e-4) << "vertex " << v << ", mesh " << as_mesh;
        }
    }
}

TEST(Vbd, keeps_the_momentum_of_a_free_sheet)
{
    const ClothModel model = square_cloth(7, 1, {}, MassLumping::area);
    SimParams params = vbd_params(5, 150);
    params.gravity_y = params.damping = 0;
    ClothState state = start_state(model, params);
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        state.velocities[v] += glm::vec4(std::sin(float(3 * v)), std::cos(float(5 * v)), std::sin(float(7 * v)), 0);
    const Momentum before = momentum(state), after = momentum(run(model, params, state, 25));
    EXPECT_LT(glm::distance(before.sum, after.sum), 1e-4 * before.size);
}

// n substeps of backward Euler from rest fall g h^2 n (n + 1) / 2, however stiff the springs.
TEST(Vbd, a_stiff_free_sheet_falls_freely)
{
    const ClothModel model = square_cloth(20, 1);
    SimParams params = vbd_params(5, 1);
    params.structural_stiffness = params.shear_stiffness = 1e6f;
    params.damping = 0;
    const ClothState start = start_state(model, params), end = run(model, params, start, 150);
    const double h = double(substep_s(params)), fall = 9.81 * h * h * 150 * 151 / 2;
    for (std::size_t v = 0; v < start.positions.size(); ++v)
        EXPECT_NEAR(double(start.positions[v].y - end.positions[v].y), fall, 1e-3 * fall);
}

// A sheet that hangs still stays so: at a stiffness of thousands of m / h^2 sweeps that do not converge would shake it.
TEST(Vbd, a_stiff_sheet_hangs_with_little_strain_and_comes_to_rest)
{
    const ClothModel model = square_cloth(33, 2, {0, 32});
    SimParams params = vbd_params(5, 0);
    params.tethers = Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = 0.2f;
    params.gravity_z = 1;
    const ClothState end = run(model, params, start_state(model, params), 5 * 480);
    EXPECT_LT(largest_thread_strain(model, end), 0.03);
    // It began with 0.8 kg * 1 m/s2 * 0.1 m of swing; e^(-8 s * damping / density) of that is 3e-5 J.
    EXPECT_LT(kinetic_energy(end), 0.01);
}

TEST(Vbd, tethers_hold_a_soft_sheet_within_its_own_length)
{
    const ClothModel model = square_cloth(17, 1, {0, 16});
    SimParams params = vbd_params(10, 2);
    params.structural_stiffness = params.shear_stiffness = 5;
    const ClothState loose = run(model, params, start_state(model, params), 300);
    params.tethers = Tethers::pins;
    const ClothState held = run(model, params, start_state(model, params), 300);
    float furthest_loose = 0, furthest_held = 0;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        for (const std::uint32_t pin : {0u, 16u}) {
            const float length = glm::distance(model.rest_positions[v], model.rest_positions[pin]);
            const auto way = [&](const ClothState& s) {
                return glm::distance(glm::vec3(s.positions[v]), glm::vec3(s.positions[pin])) - length;
            };
            furthest_loose = std::max(furthest_loose, way(loose));
            furthest_held = std::max(furthest_held, way(held));
        }
    EXPECT_GT(furthest_loose, 0.1f);
    EXPECT_LT(furthest_held, 0.01f);  // springs still move what the tether has put back
}

// Hung on one spring of k with limit e, a mass m rests where k (l - l0) + K (l - (1 + e) l0) = m g, K = stiffer k.
TEST(Vbd, the_strain_limit_stiffens_a_spring_that_is_stretched_past_it)
{
    const ClothModel model = one_spring();
    SimParams params = vbd_params(5, 20);
    params.structural_stiffness = 4;
    params.strain_limit = 0.1f;
    params.damping = 4;
    const VbdTerms terms = vbd_terms(model, params);
    const ClothState end = run(model, params, start_state(model, params), 5 * 600);
    const double k = 4, big = double(terms.stiffer) * k, weight = 0.2 * 9.81;
    const double length = (weight + k + big * double(terms.longest)) / (k + big);
    EXPECT_GT(weight / k, 0.4) << "without the limit it would stretch further";
    EXPECT_NEAR(double(glm::distance(glm::vec3(end.positions[0]), glm::vec3(end.positions[1]))), length, 1e-4);
    EXPECT_LT(length, 1.12);
}

TEST(Vbd, live_changes_of_parameters_do_not_blow_up)
{
    const ClothModel model = square_cloth(17, 1, {0, 16});
    SimParams params = vbd_params(5, 0);
    ThreadPool pool(1);
    CpuVbd solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    solver.upload(state);
    const auto frames = [&](int count) {
        for (int frame = 0; frame < count; ++frame) solver.step({params, 0, params.substeps});
    };
    frames(30);
    params.structural_stiffness = params.shear_stiffness = 1e6f;
    frames(30);
    params.substeps = 60;
    frames(10);
    params.substeps = 1;
    params.tethers = Tethers::pins;
    frames(30);
    params.structural_stiffness = 0.01f;
    params.stiffness_damping = 1;
    params.strain_limit = 0.1f;
    frames(30);
    solver.set_vertex(280, {0, 1, 1, 0});
    frames(30);
    solver.set_vertex(280, {0, 1, 1, state.positions[280].w});
    params.bending_warp = params.bending_weft = params.bending_bias = 1;
    frames(30);
    ASSERT_EQ(solver.first_lost(), std::nullopt);
    solver.download_positions(state.positions);
    for (const glm::vec4& p : state.positions) EXPECT_LT(glm::length(glm::vec3(p)), 50);
}

}  // namespace
}  // namespace nuno
