// The extremes: a method that is stable at any substep, or that nuno chooses, makes no energy and stays within reach
// whatever it is given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "solver/extremes.h"

namespace nuno {
namespace {

double furthest_from_origin(const ClothState& state)
{
    double furthest = 0;
    for (const glm::vec4& p : state.positions) furthest = std::max(furthest, glm::length(glm::dvec3(p)));
    return furthest;
}

TEST_P(ExtremesTest, stiffness_over_ten_decades)
{
    for (float k = 1e-4f; k <= 1e6f; k *= 10) {
        params_.structural_stiffness = k;
        params_.shear_stiffness = k / 2;
        params_.bend_stiffness = k / 50;
        expect_no_energy_is_made(model_, start_state(model_, params_), 40, std::to_string(k).c_str());
    }
}

// From 1 s to 1e-6 s.
TEST_P(ExtremesTest, substeps_over_six_decades)
{
    params_.structural_stiffness = 1e4f;
    for (const auto& [rate, substeps] :
         {std::pair(1, 1), {10, 1}, {100, 1}, {1000, 1}, {1000, 10}, {1000, 100}, {1000, 1000}})
    {
        params_.frame_rate = rate;
        if (params_.method != Method::automatic) params_.substeps = substeps;
        const std::string what = std::to_string(rate) + " / s, substeps " + std::to_string(substeps);
        expect_no_energy_is_made(model_, start_state(model_, params_), std::max(1, 30 / substeps), what.c_str());
    }
}

// A sheet whose cells grow from 1 mm to 1 m, so that the masses of vertices are 1 to 1e6.
TEST_P(ExtremesTest, mass_ratios_of_a_million)
{
    SheetSource source = square_sheet(12, 1, {0});
    for (glm::vec3& p : source.mesh.positions)
        for (int axis = 0; axis < 2; ++axis)
            p[axis] = std::copysign(std::pow(2.0f, std::abs(p[axis]) * 12) - 1, p[axis]) / 1000;
    source.columns = source.rows = 0;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    const auto [least, most] = std::minmax_element(model.areas.begin(), model.areas.end());
    ASSERT_GT(*most / *least, 1e6f);
    params_.structural_stiffness = 1e4f;
    const ClothState state = start_state(model, params_);
    if (params_.sweep == Sweep::rows) {  // these cells are not equal
        EXPECT_THROW(start(model, state), Error);
        return;
    }
    expect_no_energy_is_made(model, state, 60, "mass ratio");
}

ClothState in_one_point(ClothState state)
{
    for (glm::vec4& p : state.positions) p = {0, 0, 0, p.w};
    return state;
}

TEST_P(ExtremesTest, a_start_with_all_vertices_in_one_point)
{
    if (params_.method == Method::automatic) params_.structural_stiffness = 1e4f;
    expect_no_energy_is_made(model_, in_one_point(start_state(model_, params_)), 60, "one point");
}

TEST_P(ExtremesTest, a_start_stretched_a_thousandfold)
{
    params_.structural_stiffness = 1e4f;
    ClothState state = start_state(model_, params_);
    for (glm::vec4& p : state.positions)
        if (p.w > 0) p = glm::vec4(1000.0f * glm::vec3(p), p.w);
    expect_no_energy_is_made(model_, state, 60, "stretched");
}

// Wind at U, gusts of U / 2 along each axis: no vertex outruns twice the fastest air. The sheet, of about k across and
// a pressure rho Cn u^2 / 2 on 1 m2, stretches by 2 F / k at most.
TEST_P(ExtremesTest, wind_of_100_meters_a_second)
{
    params_.wind_model = WindModel::aero;
    params_.wind_z = 100;
    params_.gust_speed = 50;
    params_.structural_stiffness = 1e4f;
    Run run = start(model_, start_state(model_, params_));
    const ClothState end = finish(run, model_, 60, "wind");
    const double air = 100 + 50 * std::sqrt(3.0), load = 1.2 * 2 / 2 * air * air;
    const Diagnostics after = measure(model_, end, run.params);
    EXPECT_LT(after.max_speed, 2 * air);
    EXPECT_LT(furthest_from_origin(end), std::sqrt(2) + 2 * load / 1e4);
}

TEST_P(ExtremesTest, gravity_of_0_and_of_1000)
{
    for (const float g : {0.0f, -1000.0f}) {
        params_.gravity_y = g;
        expect_no_energy_is_made(model_, start_state(model_, params_), 60, "gravity");
    }
}

TEST_P(ExtremesTest, a_start_at_1000_meters_a_second)
{
    ClothState state = start_state(model_, params_);
    for (glm::vec4& v : state.velocities) v.z = 1000;
    expect_no_energy_is_made(model_, state, 30, "speed");
}

TEST_P(ExtremesTest, a_pin_that_jumps_a_meter)
{
    Run run = start(model_, start_state(model_, params_));
    finish(run, model_, 5, "before the jump");
    run.solver->set_vertex(0, {1, 1, 1, 0});
    const Diagnostics before = measure(model_, state_of(*run.solver, model_), run.params);
    const ClothState end = finish(run, model_, 30, "jump");
    expect_less_energy(run.params, before, measure(model_, end, run.params), 30, "jump");
}

// Each change can bring in the energy of the strain that is there: nothing flies further than a few lengths of cloth.
TEST_P(ExtremesTest, parameters_that_jump_between_frames)
{
    params_.structural_stiffness = 1e6f;  // what auto chooses, it chooses once
    Run run = start(model_, start_state(model_, params_));
    SimParams& params = run.params;
    for (int frame = 0; frame < 60; ++frame) {
        params.structural_stiffness = frame % 3 == 0 ? 1e6f : 1.0f;
        params.bend_stiffness = frame % 4 == 0 ? 0.0f : 1e3f;
        params.substeps = 1 + frame % 5;
        params.damping = frame % 7 == 0 ? 100.0f : 0.0f;
        params.wind_mean = frame % 2 == 0 ? 50.0f : -50.0f;
        params.iterations = frame % 6;
        params.strain_limit = method_info(params.method).takes_tethers && frame % 5 == 0 ? 0.05f : 0.0f;
        run.solver->step({params, frame / 60.0, params.substeps});
        ASSERT_EQ(run.solver->first_lost(), std::nullopt) << "frame " << frame;
    }
    EXPECT_LT(furthest_from_origin(state_of(*run.solver, model_)), 10);
}

INSTANTIATE_TEST_SUITE_P(Methods, ExtremesTest, testing::ValuesIn(extremes_to_test()), kMethodName);

}  // namespace
}  // namespace nuno
