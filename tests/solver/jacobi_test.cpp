// XPBD with all springs at once (sweep = jacobi) on the CPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "solver/solver_runs.h"
#include "solver/xpbd/jacobi_springs.h"

namespace nuno {
namespace {

SimParams jacobi_params(int substeps)
{
    SimParams params = on_cpu(Method::xpbd, Sweep::jacobi);
    params.frame_rate = 60;
    params.substeps = substeps;
    return params;
}

// W K has its eigenvalues in [0, 1] (jacobi_springs.h): power iteration on x -> W K x, K the sum over springs of
// share n n^T.
TEST(Jacobi, a_pass_takes_no_more_than_all_of_any_mode)
{
    SheetSource source = square_mesh(9, 1, 16);
    source.pins = {4};
    for (const ClothModel& model :
         {square_cloth(9, 1, {0}, MassLumping::area), build_cloth_model(std::span(&source, 1), MassLumping::area)})
        for (const float stiffness : {1.0f, 1e3f, 1e6f}) {
            SimParams params = jacobi_params(5);
            params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = stiffness;
            const ClothState start = start_state(model, params);
            std::vector<float> inverse_masses;
            for (const glm::vec4& p : start.positions) inverse_masses.push_back(p.w);
            const JacobiSprings springs = make_jacobi_springs(model, params, inverse_masses);
            std::vector<glm::dvec3> x(model.vertex_count()), next(model.vertex_count());
            for (std::size_t v = 0; v < x.size(); ++v)
                x[v] = glm::dvec3(std::sin(3.0 * double(v)), std::cos(double(v)), 1);
            double largest = 0;
            for (int turn = 0; turn < 300; ++turn) {
                double before = 0, after = 0;
                for (std::size_t v = 0; v < x.size(); ++v) {
                    glm::dvec3 sum(0);
                    for (int slot = 0; slot < springs.slot_count; ++slot) {
                        const std::size_t i = std::size_t(slot) * x.size() + v;
                        const std::uint32_t other = springs.neighbours[i];
                        if (other == v) continue;
                        const glm::dvec3 n = glm::normalize(glm::dvec3(model.rest_positions[other]) -
                                                            glm::dvec3(model.rest_positions[v]));
                        sum += double(springs.share[i]) * glm::dot(n, x[v] - x[other]) * n;
                    }
                    next[v] = double(inverse_masses[v]) * sum;
                    before += glm::dot(x[v], x[v]);
                    after += glm::dot(next[v], next[v]);
                }
                largest = std::sqrt(after / before);
                for (std::size_t v = 0; v < x.size(); ++v) x[v] = next[v] / std::sqrt(after);
            }
            EXPECT_LT(largest, 1 + 1e-5) << "stiffness " << stiffness;
            EXPECT_GT(largest, 0);
        }
}

TEST(Jacobi, keeps_the_momentum_of_a_free_sheet)
{
    const ClothModel model = square_cloth(12, 1, {}, MassLumping::area);
    SimParams params = jacobi_params(5);
    params.gravity_y = params.damping = 0;
    params.structural_stiffness = 1e4f;
    ClothState state = start_state(model, params);
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        state.velocities[v] += glm::vec4(std::sin(float(3 * v)), std::cos(float(5 * v)), std::sin(float(7 * v)), 0);
    const Momentum before = momentum(state), after = momentum(run(model, params, state, 100));
    // Each pass rounds positions to 1e-7 m, 8 passes a substep of 1/300 s, over sqrt(144 x 800) independent ones.
    EXPECT_LT(glm::distance(before.sum, after.sum), 2e-4 * before.size);
}

TEST(Jacobi, a_stiff_sheet_hangs_with_little_strain_and_comes_to_rest)
{
    const ClothModel model = square_cloth(33, 2, {0, 32});
    SimParams params = jacobi_params(5);
    params.tethers = Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.gravity_z = 1;
    const ClothState end = run(model, params, start_state(model, params), 5 * 480);
    EXPECT_LT(largest_thread_strain(model, end), 0.03);
    EXPECT_LT(kinetic_energy(end), 0.01);
}

TEST(Jacobi, stays_finite_at_any_stiffness_and_substep)
{
    const ClothModel model = square_cloth(12, 1, {0, 11}, MassLumping::area);
    for (float stiffness = 1e-4f; stiffness <= 1e6f; stiffness *= 100)
        for (const auto& [rate, substeps] : {std::pair(1, 1), {10, 10}, {60, 5}, {1000, 100}}) {
            SimParams params = jacobi_params(substeps);
            params.frame_rate = rate;
            params.structural_stiffness = params.shear_stiffness = stiffness;
            params.strain_limit = stiffness > 1 ? 0.1f : 0.0f;
            const ClothState end = run(model, params, start_state(model, params), 60);
            const float time_s = 60.0f / float(rate * substeps);
            for (const glm::vec4& p : end.positions) EXPECT_LT(glm::length(glm::vec3(p)), 10 + 10 * time_s * time_s);
        }
}

TEST(Jacobi, one_two_and_three_threads_give_the_same_bits)
{
    const ClothModel model = square_cloth(50, 1, {0, 49});
    SimParams params = jacobi_params(5);
    params.tethers = Tethers::pins;
    const ClothState start = start_state(model, params);
    const std::uint64_t one = state_hash(run(model, params, start, 7, 1));
    EXPECT_EQ(state_hash(run(model, params, start, 7, 2)), one);
    EXPECT_EQ(state_hash(run(model, params, start, 7, 3)), one);
}

TEST(Jacobi, refuses_bending_that_is_not_made_of_springs_and_says_what_would_do)
{
    const ClothModel model = square_cloth(5, 1, {0});
    SimParams params = jacobi_params(5);
    params.bending_warp = 1e-3f;
    ThreadPool pool(1);
    try {
        make_solver(model, kNoBodies, params, pool);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("choose coloured"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace nuno
