// One scene in motion: time, live changes, dragging, and what happens when numbers go bad.
#include "sim/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

SimParams cpu_params(const Scene& scene)
{
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    return params;
}

Simulation cpu_simulation(const std::string& name)
{
    const Scene scene = load_scene(name);
    return Simulation(scene, cpu_params(scene));
}

TEST(Simulation, an_uneven_frame_time_does_not_change_the_result)
{
    Simulation even = cpu_simulation("seed"), uneven = cpu_simulation("seed");
    for (int i = 0; i < 60; ++i) even.advance_frame();
    const double waits[] = {0.004, 0.031, 0.0001, 0.02, 0.05, 0.013};
    for (int i = 0; uneven.frame() < 60; ++i) uneven.advance(std::min(waits[i % 6], (60 - uneven.frame()) / 60.0));
    EXPECT_EQ(uneven.frame(), 60);
    EXPECT_EQ(hash_text(even.state()), hash_text(uneven.state()));
}

TEST(Simulation, a_long_wait_slows_the_cloth_down_instead_of_spiralling)
{
    Simulation simulation = cpu_simulation("seed");
    EXPECT_LE(simulation.advance(10).size(), 4u);
    EXPECT_TRUE(simulation.advance(0).empty()) << "the rest of the wait is forgotten";
}

TEST(Simulation, a_restart_gives_the_same_run_again)
{
    Simulation simulation = cpu_simulation("seed");
    for (int i = 0; i < 20; ++i) simulation.advance_frame();
    const std::string hash = hash_text(simulation.state());
    simulation.restart();
    EXPECT_EQ(simulation.frame(), 0);
    for (int i = 0; i < 20; ++i) simulation.advance_frame();
    EXPECT_EQ(hash_text(simulation.state()), hash);
}

TEST(Simulation, a_live_change_acts_in_the_next_frame_without_restart_or_pop)
{
    Simulation calm = cpu_simulation("seed"), changed = cpu_simulation("seed");
    for (int i = 0; i < 30; ++i) calm.advance_frame(), changed.advance_frame();
    SimParams params = changed.params();
    params.wind_mean = 5;
    params.structural_stiffness *= 2;
    const std::vector<glm::vec4> before = changed.state().positions;
    changed.set_params(params);
    EXPECT_EQ(changed.state().positions, before) << "a change moves nothing by itself";
    changed.advance_frame();
    calm.advance_frame();
    EXPECT_EQ(changed.frame(), 31);
    double step = 0, difference = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
        step = std::max(step, double(glm::distance(glm::vec3(before[v]), glm::vec3(changed.state().positions[v]))));
        difference = std::max(difference, double(glm::distance(glm::vec3(calm.state().positions[v]),
                                                               glm::vec3(changed.state().positions[v]))));
    }
    EXPECT_GT(difference, 1e-5);
    EXPECT_LT(step, 0.15) << "a frame at the seed's speeds, and no jump";
}

TEST(Simulation, a_change_of_density_changes_the_masses_and_of_the_start_starts_again)
{
    Simulation simulation = cpu_simulation("seed");
    simulation.advance_frame();
    SimParams params = simulation.params();
    params.areal_density *= 2;
    const float before = simulation.state().positions[40].w;
    simulation.set_params(params);
    EXPECT_FLOAT_EQ(simulation.state().positions[40].w, before / 2);
    EXPECT_EQ(simulation.frame(), 1);
    params.resolution = 9;
    simulation.set_params(params);
    EXPECT_EQ(simulation.frame(), 0);
    EXPECT_EQ(simulation.model().vertex_count(), 81u);
}

TEST(Simulation, a_held_vertex_goes_to_its_target_and_comes_free_again)
{
    Simulation simulation = cpu_simulation("seed");
    const std::uint32_t v = 16 * 17 + 8;
    const glm::vec3 target(0.15f, 0.25f, 0.4f);
    for (int i = 0; i < 60; ++i) {
        simulation.hold_vertex(v, target);
        const glm::vec3 before(simulation.state().positions[v]);
        simulation.advance_frame();
        EXPECT_LE(glm::distance(before, glm::vec3(simulation.state().positions[v])), 3.001f / 60);
    }
    EXPECT_LT(glm::distance(glm::vec3(simulation.state().positions[v]), target), 1e-5f);
    simulation.release_vertex();
    for (int i = 0; i < 10; ++i) simulation.advance_frame();
    EXPECT_GT(glm::distance(glm::vec3(simulation.state().positions[v]), target), 0.01f);
}

TEST(Simulation, pulling_at_a_vertex_never_tears_the_cloth_apart)
{
    for (const char* name : {"seed", "hang", "flag"}) {
        Simulation simulation = cpu_simulation(name);
        const std::uint32_t v = simulation.model().vertex_count() / 2 + 3;
        for (int i = 0; i < 45; ++i) {
            simulation.hold_vertex(v, glm::vec3(simulation.model().rest_positions[v]) + glm::vec3(0.5f, 1, 2));
            simulation.advance_frame();
        }
        const Diagnostics held = simulation.diagnostics();
        EXPECT_LT(held.max_strain, 1) << name << ": no thread is pulled to twice its length";
        EXPECT_GT(glm::distance(glm::vec3(simulation.state().positions[v]), simulation.model().rest_positions[v]), 0.3f)
            << name;
        simulation.release_vertex();
        for (int i = 0; i < 15; ++i) simulation.advance_frame();
        EXPECT_LT(simulation.diagnostics().max_speed, 30) << name;
    }
}

TEST(Simulation, a_change_of_threads_goes_on_with_the_same_bits)
{
    Simulation one = cpu_simulation("seed"), two = cpu_simulation("seed");
    for (int i = 0; i < 20; ++i) {
        SimParams params = two.params();
        params.threads = 1 + i % 3;
        two.set_params(params);
        one.advance_frame();
        two.advance_frame();
    }
    EXPECT_EQ(two.frame(), 20);
    EXPECT_EQ(hash_text(one.state()), hash_text(two.state()));
}

TEST(Simulation, numbers_gone_bad_end_it_with_the_setting_that_holds)
{
    const Scene scene = load_scene("hang");
    SimParams params = cpu_params(scene);
    params.method = Method::symplectic_euler;
    params.substeps = 40;
    Simulation simulation(scene, params);
    ASSERT_TRUE(simulation.stability_warning());
    std::string message;
    try {
        for (int i = 0; i < 100; ++i) simulation.advance_frame();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::went_bad);
        message = error.what();
    }
    EXPECT_THAT(message,
                testing::AllOf(testing::HasSubstr("hang"), testing::HasSubstr("frame"), testing::HasSubstr("substeps"),
                               testing::HasSubstr("vertex"), testing::HasSubstr("--set substeps=")));
    // The advice is true.
    const std::size_t at = message.find("--set substeps=") + 15;
    params.substeps = std::stoi(message.substr(at));
    Simulation advised(scene, params);
    EXPECT_EQ(advised.stability_warning(), std::nullopt);
    for (int i = 0; i < 30; ++i) advised.advance_frame();
    EXPECT_LT(advised.diagnostics().max_strain, 0.1);
}

TEST(Simulation, without_self_collision_no_contact_is_looked_for)
{
    const Scene scene = load_scene("seed");
    SimParams params = cpu_params(scene);
    params.collision = CollisionLevel::none;
    params.count_pass_through = 0;
    Simulation simulation(scene, params);
    for (int i = 0; i < 100; ++i) {
        const FrameStats stats = simulation.advance_frame();
        EXPECT_EQ(stats.count.pairs_tested, 0u);
        EXPECT_EQ(stats.stage_ms.readback, 0);
    }
}

}  // namespace
}  // namespace nuno
