// What automatic settings promise: every fabric keeps together, and nothing that is changed while it moves breaks that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "model/fabric.h"
#include "sim/simulation.h"
#include "solver/method_choice.h"

namespace nuno {
namespace {

SimParams small_params(const Scene& scene, int resolution)
{
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    params.threads = 1;
    params.collision = CollisionLevel::none;
    params.count_pass_through = 0;
    params.resolution = resolution;
    return params;
}

using Choice = std::tuple<const char*, Fabric, InternalModel>;

class AutomaticSubsteps : public testing::TestWithParam<Choice>
{};

// Elastic energy of a sheet that falls 2 m at most is no more than gravity gave it.
TEST_P(AutomaticSubsteps, hold_every_fabric_together)
{
    const auto [name, fabric, internal_model] = GetParam();
    const Scene scene = load_scene(name);
    SimParams params = small_params(scene, 20);
    params.substeps = 0;
    set_param(*find_param(sim_param_table(), "fabric"), &params, double(fabric), "test");
    params.internal_model = internal_model;
    Simulation simulation(scene, params);
    const double start_j = simulation.diagnostics().gravity_j;
    for (int frame = 0; frame < 90; ++frame) {
        simulation.advance_frame();
        const Diagnostics d = simulation.diagnostics();
        ASSERT_LE(d.gravity_j + d.elastic_j + d.kinetic_j, start_j + 0.02 * std::abs(d.gravity_j - start_j) + 1e-3)
            << "frame " << frame;
        ASSERT_EQ(simulation.present_warning(), std::nullopt) << "frame " << frame;
    }
}

std::string name_of(const testing::TestParamInfo<Choice>& info)
{
    const auto& [scene, fabric, internal_model] = info.param;
    return std::string(scene) + "_" + std::string(choice_names(fabric)[std::size_t(fabric)]) + "_" +
           std::string(choice_names(internal_model)[std::size_t(internal_model)]);
}

INSTANTIATE_TEST_SUITE_P(Fabrics, AutomaticSubsteps,
                         testing::Combine(testing::Values("hang", "swing"),
                                          testing::Values(Fabric::cotton, Fabric::silk, Fabric::wool, Fabric::denim),
                                          testing::Values(InternalModel::fabric_springs, InternalModel::continuum)),
                         name_of);

// Springs stiffen by at most 2 in omega^2 however far they are stretched.
TEST(Automatic, substeps_hold_a_cloth_soft_enough_to_stretch_tenfold)
{
    const Scene scene = load_scene("hang");
    SimParams params = small_params(scene, 16);
    params.structural_stiffness = 1;
    params.shear_stiffness = 0.5f;
    params.bend_stiffness = 0.1f;
    params.method = Method::symplectic_euler;
    Simulation simulation(scene, params);
    for (int frame = 0; frame < 240; ++frame) simulation.advance_frame();
    EXPECT_GT(simulation.diagnostics().max_strain, 3);
    EXPECT_EQ(simulation.present_warning(), std::nullopt);
}

TEST(Automatic, substeps_hold_in_a_storm)
{
    const Scene scene = load_scene("hang");
    SimParams params = small_params(scene, 16);
    params.structural_stiffness = 500;
    params.shear_stiffness = 250;
    params.bend_stiffness = 10;
    params.wind_model = WindModel::aero;
    params.wind_z = 100;
    Simulation simulation(scene, params);
    for (int frame = 0; frame < 120; ++frame) simulation.advance_frame();
    EXPECT_EQ(simulation.present_warning(), std::nullopt);
}

TEST(Automatic, tethers_are_left_out_where_pins_move_apart)
{
    const Scene twist = load_scene("twist"), hang = load_scene("hang");
    SimParams params = small_params(twist, 16);
    params.method = Method::xpbd;
    EXPECT_EQ(Simulation(twist, params).params().tethers, Tethers::none);
    params = small_params(hang, 16);
    params.method = Method::xpbd;
    EXPECT_EQ(Simulation(hang, params).params().tethers, Tethers::pins);
}

// Substeps are for a second of time, not for a frame; cloth that lies loose, or on a body, needs more of them.
TEST(Automatic, substeps_follow_the_load)
{
    const Scene hang = load_scene("hang"), drape = load_scene("drape");
    const auto substeps = [](const Scene& scene, Method method, int frame_rate) {
        SimParams params = small_params(scene, 32);
        params.method = method;
        params.substeps = 0;
        params.frame_rate = frame_rate;
        return Simulation(scene, params).params().substeps;
    };
    EXPECT_EQ(substeps(hang, Method::xpbd, 60), 4);  // ceil(6.4 / 2^0.7)
    EXPECT_EQ(substeps(hang, Method::xpbd, 30), 8);
    EXPECT_EQ(substeps(hang, Method::sdirk2, 60), 2);
    EXPECT_EQ(substeps(hang, Method::sdirk2, 1000), 1);
    EXPECT_GT(substeps(drape, Method::xpbd, 60), 8);
    EXPECT_EQ(substeps(drape, Method::sdirk2, 60), 16);
}

class OnABody : public testing::TestWithParam<Method>
{};

TEST_P(OnABody, cloth_lies_with_automatic_substeps_without_being_torn)
{
    const Scene scene = load_scene("table");
    SimParams params = small_params(scene, 33);
    params.method = GetParam();
    params.substeps = 0;
    Simulation simulation(scene, params);
    for (int frame = 0; frame < 90; ++frame) {
        simulation.advance_frame();
        ASSERT_LT(simulation.diagnostics().max_strain, 0.35) << "frame " << frame;
    }
    EXPECT_NEAR(simulation.diagnostics().highest.y, 0.765, 0.02);  // the top, and the thickness
}

const auto method_name = [](const testing::TestParamInfo<Method>& method) {
    return std::string(choice_names(method.param)[std::size_t(method.param)]);
};

// Stiff cloth bent over an edge takes up energy where substeps are too long for it.
TEST_P(OnABody, stiff_cloth_comes_to_rest_with_automatic_substeps)
{
    const Scene scene = load_scene("table");
    SimParams params = small_params(scene, 33);
    params.method = GetParam();
    params.substeps = 0;
    params.fabric = Fabric::custom;
    params.internal_model = InternalModel::springs;
    params.areal_density = 0.2f;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    Simulation simulation(scene, params);
    double most_kinetic_j = 0;
    for (int frame = 0; frame < 90; ++frame) {
        simulation.advance_frame();
        if (frame < 45) continue;
        ASSERT_LT(simulation.diagnostics().max_strain, 0.15) << "frame " << frame;
        most_kinetic_j = std::max(most_kinetic_j, simulation.diagnostics().kinetic_j);
    }
    EXPECT_LT(most_kinetic_j, 0.1);  // of 0.7 J that the fall to the table gave
}

INSTANTIATE_TEST_SUITE_P(Methods, OnABody,
                         testing::Values(Method::automatic, Method::xpbd, Method::vbd, Method::implicit_euler,
                                         Method::sdirk2),
                         method_name);

class LiveChanges : public testing::TestWithParam<Method>
{};

// Every parameter that a slider changes, to either end of its range and back.
TEST_P(LiveChanges, of_any_parameter_keep_a_stable_method_finite)
{
    const Scene scene = load_scene("seed");
    SimParams params = small_params(scene, 9);
    params.method = GetParam();
    params.substeps = 0;
    Simulation simulation(scene, params);
    for (const ParamInfo& info : sim_param_table()) {
        if (needs_restart(info.name) || info.group == "machine" || info.name == "method") continue;
        for (double value : {info.min, info.max}) {
            if (info.group == "time" && info.name != "sweep") value = std::min(value, 100.0);
            SimParams changed = simulation.asked_params();
            set_param(info, &changed, value, "test");
            try {
                simulation.set_params(changed);
            } catch (const Error& error) {  // a choice that this method lacks changes nothing
                EXPECT_EQ(error.code(), ExitCode::bad_input) << info.name;
                continue;
            }
            for (int frame = 0; frame < 3; ++frame)
                ASSERT_NO_THROW(simulation.advance_frame()) << info.name << " " << value;
            simulation.set_params(params);
            for (int frame = 0; frame < 3; ++frame)
                ASSERT_NO_THROW(simulation.advance_frame()) << "after " << info.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, LiveChanges,
                         testing::Values(Method::automatic, Method::xpbd, Method::vbd, Method::implicit_euler,
                                         Method::sdirk2),
                         method_name);

}  // namespace
}  // namespace nuno
