// The explicit methods on the CPU: closed forms, and the order at which their error falls.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "solver/explicit_runs.h"

namespace nuno {
namespace {

// So soft that explicit Euler, too, is stable at the substeps used here.
void soften(SimParams& params) { params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-3f; }

class ExplicitTest : public testing::TestWithParam<Method>
{};

// v(t) = (m g / c) (1 - e^(-c t / m)), y(t) = (m g / c) (t - (m / c) (1 - e^(-c t / m))); halving h divides the error
// by 2 to the order of the method (accuracy A1). Substeps are so few that the error stays above what floats lose.
TEST_P(ExplicitTest, free_fall_with_drag_follows_the_closed_form_at_the_order_of_the_method)
{
    const ClothModel model = square_cloth(10, 1);
    SimParams params = on_cpu(GetParam());
    params.damping = 0.3f;
    soften(params);
    const double rate = 0.3 / 0.2, g = -9.81;  // c / m [1/s]
    const double speed = g / rate * (1 - std::exp(-rate)), fall = g / rate * (1 - (1 - std::exp(-rate)) / rate);
    const int order = order_of(GetParam()), least = order == 1 ? 100 : order == 2 ? 40 : 8;
    double speed_errors[2], fall_errors[2];
    for (int i = 0; i < 2; ++i) {
        params.substeps = least << i;
        const ClothState start = start_state(model, params), end = run(model, params, start, params.substeps);
        speed_errors[i] = std::abs(double(end.velocities[37].y) - speed);
        fall_errors[i] = std::abs(double(end.positions[37].y - start.positions[37].y) - fall);
    }
    EXPECT_NEAR(std::log2(speed_errors[0] / speed_errors[1]), order, 0.15);
    EXPECT_NEAR(std::log2(fall_errors[0] / fall_errors[1]), order, 0.15);
    EXPECT_LT(speed_errors[1] / std::abs(speed), 0.01);
}

// Error against a converged run of the same cloth: a swinging 5 x 5 sheet on two pegs, with both dampers, is a smooth
// problem at these substeps (accuracy A12).
TEST_P(ExplicitTest, a_damped_swinging_sheet_converges_at_the_order_of_the_method)
{
    SheetSource source = square_sheet(5, 1, {0, 4});
    for (const glm::vec3& p : source.mesh.positions) source.start.emplace_back(p.x, 0.8f * p.y, 0.6f * p.y);
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    SimParams params = on_cpu(Method::rk4);
    params.structural_stiffness = 6;
    params.shear_stiffness = 3;
    params.bend_stiffness = 1;
    params.damping = 0.1f;
    params.stiffness_damping = 2e-3f;
    params.frame_rate = 4;
    params.substeps = 512;
    const ClothState start = start_state(model, params), truth = run(model, params, start, params.substeps);
    params.method = GetParam();
    const int order = order_of(GetParam()), least = order == 1 ? 400 : order == 2 ? 48 : 12;
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        params.substeps = least << i;
        const ClothState end = run(model, params, start, params.substeps);
        double sum = 0;
        for (std::size_t v = 0; v < end.positions.size(); ++v) {
            const double error = double(glm::distance(glm::vec3(end.positions[v]), glm::vec3(truth.positions[v])));
            sum += error * error;
        }
        errors[i] = std::sqrt(sum / double(end.positions.size()));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), order, 0.15) << errors[0] << " and " << errors[1];
}

TEST_P(ExplicitTest, a_sheet_in_free_fall_keeps_its_shape)
{
    const ClothModel model = square_cloth(10, 1);
    SimParams params = on_cpu(GetParam());
    soften(params);
    params.substeps = 200;
    const ClothState start = start_state(model, params), end = run(model, params, start, 200);
    // Springs at rest feel only the rounding of positions, a few ulp of the distance fallen.
    for (std::size_t v = 1; v < start.positions.size(); ++v)
        EXPECT_NEAR(end.positions[v].y - end.positions[0].y, start.positions[v].y - start.positions[0].y, 2e-5);
}

TEST_P(ExplicitTest, momentum_without_outer_forces_is_kept)
{
    const ClothModel model = square_cloth(8, 1);
    SimParams params = on_cpu(GetParam());
    params.gravity_y = params.damping = 0;
    params.substeps = 2000;
    ClothState state = start_state(model, params);
    std::mt19937 random(2);
    std::normal_distribution<float> at(0, 0.01f);
    for (glm::vec4& p : state.positions) p += glm::vec4(at(random), at(random), at(random), 0);
    const ClothState end = run(model, params, state, 50);
    glm::dvec3 momentum(0), motion(0);
    for (const glm::vec4& v : end.velocities)
        for (int c = 0; c < 3; ++c) momentum[c] += double(v[c]), motion[c] += std::abs(double(v[c]));
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(motion[c], 0.01);
        EXPECT_LT(std::abs(momentum[c]), 1e-4 * motion[c]);
    }
}

// Cut into steps of any length, a run is the same run; and what is uploaded midway is where it goes on from.
TEST_P(ExplicitTest, a_run_does_not_depend_on_how_it_is_cut_into_steps)
{
    const ClothModel model = square_cloth(9, 1, {0, 8});
    SimParams params = on_cpu(GetParam());
    params.damping = 2;
    params.stiffness_damping = 1e-4f;
    params.substeps = 4000;
    const Bodies no_bodies;
    ThreadPool pool(1);
    ClothState whole = start_state(model, params), cut = whole;
    const auto a = make_solver(model, no_bodies, params, pool), b = make_solver(model, no_bodies, params, pool);
    a->upload(whole);
    b->upload(cut);
    a->step({params, 0, 30});
    int done = 0;
    for (const int count : {1, 7, 2, 0, 20}) {
        b->step({params, done * double(substep_s(params)), count});
        done += count;
    }
    a->download_positions(whole.positions), a->download_velocities(whole.velocities);
    b->download_positions(cut.positions), b->download_velocities(cut.velocities);
    EXPECT_EQ(state_hash(whole), state_hash(cut));

    a->set_vertex(40, {2, 3, 4, 0});
    a->step({params, 0, 10});
    cut.positions[40] = {2, 3, 4, 0};
    cut.velocities[40] = glm::vec4(glm::vec3(0), cut.velocities[40].w);
    b->upload(cut);
    b->step({params, 0, 10});
    a->download_positions(whole.positions), b->download_positions(cut.positions);
    EXPECT_EQ(whole.positions, cut.positions);
}

INSTANTIATE_TEST_SUITE_P(Methods, ExplicitTest, testing::ValuesIn(explicit_methods()),
                         [](const auto& test) { return std::string(choice_names(Method{})[std::size_t(test.param)]); });

TEST(MethodTable, every_method_has_a_name_a_backend_and_a_solver)
{
    const ClothModel model = square_cloth(3, 1);
    const Bodies no_bodies;
    ThreadPool pool(1);
    for (const MethodInfo& info : method_table()) {
        EXPECT_EQ(info.name, choice_names(Method{})[std::size_t(info.method)]);
        ASSERT_TRUE(info.on(Backend::cpu));
        const auto solver = make_solver(model, no_bodies, on_cpu(info.method), pool);
        EXPECT_EQ(solver->name(), std::string(info.name) + " on cpu");
    }
}

}  // namespace
}  // namespace nuno
