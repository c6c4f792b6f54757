// The extremes (accuracy.md A13): a method that is stable at any substep stays finite whatever it is given.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "solver/method_choice.h"
#include "solver/method_table.h"
#include "support/sheets.h"

namespace nuno {
namespace {

const Bodies kNoBodies;

bool stable_at_any_substep(Method method)
{
    return method == Method::xpbd || method == Method::vbd || method == Method::implicit_euler ||
           method == Method::sdirk2;
}

class ExtremesTest : public testing::TestWithParam<Method>
{
  protected:
    ExtremesTest()
    {
        params_.backend = Backend::cpu;
        params_.method = GetParam();
        params_.substeps = 2;
    }

    // Runs from `start` and expects every number to stay finite, and no vertex further away than it could fly.
    void expect_finite(const ClothModel& model, ClothState state, int frames, const char* what)
    {
        const SimParams params = resolve_params(model, params_);
        ThreadPool pool(1);
        const auto solver = make_solver(model, kNoBodies, params, pool);
        solver->upload(state);
        for (int frame = 0; frame < frames; ++frame) {
            solver->step({params, frame / double(params.frame_rate), params.substeps});
            ASSERT_EQ(solver->first_not_finite(), std::nullopt) << what << ", frame " << frame;
        }
        solver->download_positions(state.positions);
        const float time_s = float(frames) / float(params.frame_rate);
        const float reach = 100 + 2 * time_s * (2000 + 1000 * time_s);
        for (const glm::vec4& p : state.positions) ASSERT_LT(glm::length(glm::vec3(p)), reach) << what;
    }

    SimParams params_;
    const ClothModel model_ = square_cloth(20, 1, {0, 19}, MassLumping::area);
};

TEST_P(ExtremesTest, stiffness_over_ten_decades)
{
    for (float k = 1e-4f; k <= 1e6f; k *= 10) {
        params_.structural_stiffness = k;
        params_.shear_stiffness = k / 2;
        params_.bend_stiffness = k / 50;
        expect_finite(model_, start_state(model_, params_), 40, "stiffness");
    }
}

TEST_P(ExtremesTest, substeps_over_six_decades)
{
    params_.structural_stiffness = 1e4f;
    for (const auto& [rate, substeps] : {std::pair(1, 1), {1, 10}, {10, 10}, {100, 10}, {1000, 10}, {1000, 100}}) {
        params_.frame_rate = rate;
        params_.substeps = substeps;
        expect_finite(model_, start_state(model_, params_), 10, "substep");
    }
}

// A sheet whose cells grow from 1 mm to 1 m, so that the masses of vertices are 1 to 1e6.
TEST_P(ExtremesTest, mass_ratios_of_a_million)
{
    SheetSource source = square_sheet(12, 1, {0});
    for (glm::vec3& p : source.mesh.positions)
        for (int axis = 0; axis < 2; ++axis)
            p[axis] = std::copysign(std::pow(2.0f, std::abs(p[axis]) * 11) - 1, p[axis]) / 1000;
    source.columns = source.rows = 0;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    const auto [least, most] = std::minmax_element(model.areas.begin(), model.areas.end());
    ASSERT_GT(*most / *least, 1e5f);
    params_.structural_stiffness = 1e4f;
    expect_finite(model, start_state(model, params_), 60, "mass ratio");
}

TEST_P(ExtremesTest, a_start_with_all_vertices_in_one_point)
{
    ClothState state = start_state(model_, params_);
    for (glm::vec4& p : state.positions) p = {0, 0, 0, p.w};
    expect_finite(model_, state, 60, "one point");
}

TEST_P(ExtremesTest, a_start_stretched_a_thousandfold)
{
    params_.structural_stiffness = 1e4f;
    ClothState state = start_state(model_, params_);
    for (glm::vec4& p : state.positions)
        if (p.w > 0) p = glm::vec4(1000.0f * glm::vec3(p), p.w);
    const SimParams params = resolve_params(model_, params_);
    ThreadPool pool(1);
    const auto solver = make_solver(model_, kNoBodies, params, pool);
    solver->upload(state);
    solver->step({params, 0, 120});
    EXPECT_EQ(solver->first_not_finite(), std::nullopt);
}

TEST_P(ExtremesTest, wind_of_100_meters_a_second)
{
    params_.wind_model = WindModel::aero;
    params_.wind_z = 100;
    params_.gust_speed = 50;
    params_.structural_stiffness = 1e4f;
    expect_finite(model_, start_state(model_, params_), 60, "wind");
}

TEST_P(ExtremesTest, gravity_of_0_and_of_1000)
{
    for (const float g : {0.0f, -1000.0f}) {
        params_.gravity_y = g;
        expect_finite(model_, start_state(model_, params_), 60, "gravity");
    }
}

TEST_P(ExtremesTest, a_start_at_1000_meters_a_second_and_a_pin_that_jumps_a_meter)
{
    ClothState state = start_state(model_, params_);
    for (glm::vec4& v : state.velocities) v.z = 1000;
    expect_finite(model_, state, 30, "speed");

    const SimParams params = resolve_params(model_, params_);
    ThreadPool pool(1);
    const auto solver = make_solver(model_, kNoBodies, params, pool);
    solver->upload(start_state(model_, params_));
    solver->step({params, 0, 10});
    solver->set_vertex(0, {1, 1, 1, 0});
    solver->step({params, 0.1, 60});
    EXPECT_EQ(solver->first_not_finite(), std::nullopt);
}

TEST_P(ExtremesTest, parameters_that_jump_between_frames)
{
    SimParams params = resolve_params(model_, params_);
    ThreadPool pool(1);
    const auto solver = make_solver(model_, kNoBodies, params, pool);
    solver->upload(start_state(model_, params));
    for (int frame = 0; frame < 60; ++frame) {
        params.structural_stiffness = frame % 3 == 0 ? 1e6f : 1.0f;
        params.bend_stiffness = frame % 4 == 0 ? 0.0f : 1e3f;
        params.substeps = 1 + frame % 5;
        params.damping = frame % 7 == 0 ? 100.0f : 0.0f;
        params.wind_mean = frame % 2 == 0 ? 50.0f : -50.0f;
        params.iterations = frame % 6;
        params.strain_limit = method_info(params.method).takes_tethers && frame % 5 == 0 ? 0.05f : 0.0f;
        solver->step({params, frame / 60.0, params.substeps});
        ASSERT_EQ(solver->first_not_finite(), std::nullopt) << "frame " << frame;
    }
}

// So that a new method is tested without being named here.
std::vector<Method> stable_methods()
{
    std::vector<Method> methods;
    for (const MethodInfo& info : method_table())
        if (info.on(Backend::cpu) && stable_at_any_substep(info.method)) methods.push_back(info.method);
    return methods;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ExtremesTest);
INSTANTIATE_TEST_SUITE_P(Methods, ExtremesTest, testing::ValuesIn(stable_methods()),
                         [](const auto& test) { return std::string(choice_names(Method{})[std::size_t(test.param)]); });

}  // namespace
}  // namespace nuno
