// Vertices pinned and let go while the cloth moves, with every method.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/rewind.h"
#include "sim/run_recorder.h"
#include "sim/saved_run.h"
#include "sim/saved_scene.h"

namespace nuno {
namespace {

// A vertex in the middle of the first sheet, that nothing holds.
constexpr std::uint32_t kFree = 40;

glm::vec3 place_of(Simulation& simulation, std::uint32_t vertex)
{
    return glm::vec3(simulation.state().positions[vertex]);
}

class PinsOfMethod : public testing::TestWithParam<Method>
{
  protected:
    PinsOfMethod() { params.method = GetParam(); }
    SavedSceneFolder files;
    Scene scene = files.scene();
    SimParams params = scene.params;
};

TEST_P(PinsOfMethod, a_pinned_vertex_stays_to_the_bit_and_one_let_go_falls)
{
    if (GetParam() == Method::explicit_euler) params.damping = 30, params.substeps = 300;
    Simulation simulation(scene, params);
    advance_frames(simulation, 6);
    const glm::vec3 there = place_of(simulation, kFree);
    simulation.set_pinned(kFree, true);
    EXPECT_TRUE(simulation.is_pinned(kFree));
    advance_frames(simulation, 12);
    EXPECT_EQ(place_of(simulation, kFree), there);
    simulation.set_pinned(kFree, false);
    advance_frames(simulation, 12);
    EXPECT_GT(glm::distance(place_of(simulation, kFree), there), 1e-4f);
    simulation.restart();
    EXPECT_FALSE(simulation.is_pinned(kFree));
}

INSTANTIATE_TEST_SUITE_P(Pins, PinsOfMethod,
                         testing::Values(Method::explicit_euler, Method::symplectic_euler, Method::verlet, Method::rk4,
                                         Method::xpbd, Method::vbd, Method::implicit_euler, Method::reference,
                                         Method::sdirk2),
                         [](const auto& of) { return std::string(choice_names(Method{})[std::size_t(of.param)]); });

class Pins : public testing::Test
{
  protected:
    SavedSceneFolder files;
    Scene scene = files.scene();
};

TEST_F(Pins, a_change_of_method_and_a_saved_scene_keep_them)
{
    Simulation simulation(scene, scene.params);
    advance_frames(simulation, 5);
    const std::uint32_t scene_pin = simulation.model().vertex_count() - 1;
    ASSERT_TRUE(simulation.is_pinned(scene_pin));
    simulation.set_pinned(kFree, true);
    simulation.set_pinned(scene_pin, false);
    SimParams params = scene.params;
    params.method = Method::xpbd;
    simulation.set_params(params);
    advance_frames(simulation, 3);
    std::filesystem::create_directories(files.path() / "later");
    const auto path = files.path() / "later/pinned.toml";
    save_scene(path, simulation, {});
    const Scene saved = load_scene(path.string());
    Simulation resumed(saved, saved.params);
    EXPECT_TRUE(resumed.is_pinned(kFree));
    EXPECT_FALSE(resumed.is_pinned(scene_pin));
    advance_frames(simulation, 6);
    advance_frames(resumed, 6);
    EXPECT_EQ(hash_text(resumed.state()), hash_text(simulation.state()));
    resumed.restart();
    EXPECT_TRUE(resumed.is_pinned(kFree)) << "its start is the saved state";
    simulation.restart();
    EXPECT_FALSE(simulation.is_pinned(kFree));
    EXPECT_TRUE(simulation.is_pinned(scene_pin));
    Simulation anew(scene, params);
    EXPECT_EQ(hash_text(simulation.state()), hash_text(anew.state()));
    advance_frames(simulation, 6);
    advance_frames(anew, 6);
    EXPECT_EQ(hash_text(simulation.state()), hash_text(anew.state()));
}

TEST_F(Pins, frames_looked_back_at_have_the_pins_of_then)
{
    Simulation simulation(scene, scene.params);
    Rewind rewind;
    rewind.keep(simulation);
    for (int frame = 0; frame < 8; ++frame) {
        if (frame == 4) simulation.set_pinned(kFree, true);
        simulation.advance_frame();
        rewind.keep(simulation);
    }
    const std::string end = hash_text(simulation.state());
    rewind.show(simulation, 2);
    EXPECT_FALSE(simulation.is_pinned(kFree));
    rewind.show(simulation, 6);
    EXPECT_TRUE(simulation.is_pinned(kFree));
    advance_frames(simulation, 2);
    EXPECT_EQ(hash_text(simulation.state()), end);
}

TEST_F(Pins, a_vertex_let_go_of_its_handle_falls_and_cannot_be_hung_again)
{
    Simulation simulation(scene, scene.params);
    ASSERT_FALSE(simulation.model().handle_pins.empty());
    const std::uint32_t vertex = simulation.model().handle_pins.front().vertex;
    simulation.set_pinned(vertex, false);
    const glm::vec3 there = place_of(simulation, vertex);
    advance_frames(simulation, 20);
    EXPECT_LT(place_of(simulation, vertex).y, there.y - 0.01f);
    EXPECT_THROW(simulation.set_pinned(vertex, true), Error);
    EXPECT_FALSE(simulation.is_pinned(vertex));
    simulation.restart();
    advance_frames(simulation, 20);
    EXPECT_GT(place_of(simulation, vertex).y, there.y) << "the bar lifts it";
}

TEST_F(Pins, a_vertex_in_the_hand_is_released_where_it_is_pinned)
{
    Simulation simulation(scene, scene.params);
    simulation.hold_vertex(kFree, place_of(simulation, kFree) + glm::vec3(0, 1, 0));
    advance_frames(simulation, 3);
    simulation.set_pinned(kFree, true);
    const glm::vec3 there = place_of(simulation, kFree);
    advance_frames(simulation, 3);
    EXPECT_EQ(place_of(simulation, kFree), there);
}

}  // namespace
}  // namespace nuno
