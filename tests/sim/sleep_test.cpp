// Cloth that has come to rest costs nothing until something moves it.
#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "sim/run_recorder.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

constexpr int kLongFrames = 1200;

// A sheet that hangs by its upper side and comes to rest within some seconds.
Scene hanging_sheet()
{
    Scene scene;
    scene.name = "sleeper";
    scene.params.backend = Backend::cpu;
    scene.params.threads = 1;
    scene.params.method = Method::xpbd;
    scene.params.substeps = 10;
    scene.params.damping = 2;
    SheetSpec sheet;
    sheet.name = sheet.where = "sheet";
    sheet.columns = sheet.rows = 13;
    sheet.across = {0.6f, 0, 0};
    sheet.down = {0, -0.6f, 0.1f};
    PinSpec side;
    side.where = "sheet";
    side.places = {"top"};
    sheet.pins = {side};
    scene.sheets = {sheet};
    return scene;
}

// Frames until one had no substeps, or kLongFrames.
int frames_until_asleep(Simulation& simulation)
{
    for (int frame = 1; frame < kLongFrames; ++frame)
        if (simulation.advance_frame().substeps == 0) return frame;
    return kLongFrames;
}

double largest_way(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b)
{
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        largest = std::max(largest, double(glm::distance(glm::vec3(a[v]), glm::vec3(b[v]))));
    return largest;
}

TEST(Sleep, cloth_at_rest_sleeps_and_its_time_goes_on)
{
    const Scene scene = hanging_sheet();
    Simulation simulation(scene, scene.params);
    const int asleep = frames_until_asleep(simulation);
    ASSERT_LT(asleep, kLongFrames);
    ASSERT_GT(asleep, 60) << "it falls into its shape first";
    const std::string hash = hash_text(simulation.state());
    const double time_s = simulation.time_s();
    for (int frame = 0; frame < 30; ++frame) EXPECT_EQ(simulation.advance_frame().substeps, 0);
    EXPECT_EQ(hash_text(simulation.state()), hash);
    EXPECT_NEAR(simulation.time_s() - time_s, 0.5, 1e-9);
    EXPECT_EQ(simulation.frame(), asleep + 30);
}

TEST(Sleep, cloth_asleep_is_where_it_would_have_come_to_rest)
{
    const Scene scene = hanging_sheet();
    SimParams never = scene.params;
    never.sleep_motion = 0;
    Simulation asleep(scene, scene.params), awake(scene, never);
    ASSERT_LT(frames_until_asleep(asleep), kLongFrames);
    for (int frame = 0; frame < kLongFrames; ++frame) ASSERT_GT(awake.advance_frame().substeps, 0);
    EXPECT_LT(largest_way(asleep.state().positions, awake.state().positions), 2e-4) << "four times the threshold";
}

TEST(Sleep, ends_with_a_change_of_parameters_a_hand_and_a_restart)
{
    const Scene scene = hanging_sheet();
    Simulation simulation(scene, scene.params);
    ASSERT_LT(frames_until_asleep(simulation), kLongFrames);
    const std::vector<glm::vec4> at_rest = simulation.state().positions;
    SimParams windy = scene.params;
    windy.wind_mean = 0.5f;
    simulation.set_params(windy);
    EXPECT_GT(simulation.advance_frame().substeps, 0);
    for (int frame = 0; frame < 20; ++frame) simulation.advance_frame();
    EXPECT_GT(largest_way(simulation.state().positions, at_rest), 0.01);

    ASSERT_LT(frames_until_asleep(simulation), kLongFrames);
    simulation.hold_vertex(150, {0.3f, -0.4f, 0.3f});
    EXPECT_GT(simulation.advance_frame().substeps, 0);
    simulation.release_vertex();
    EXPECT_GT(simulation.advance_frame().substeps, 0);

    ASSERT_LT(frames_until_asleep(simulation), kLongFrames);
    simulation.restart();
    EXPECT_GT(simulation.advance_frame().substeps, 0);
}

TEST(Sleep, ends_when_a_handle_begins_to_move)
{
    Scene scene = hanging_sheet();
    Handle hand;
    hand.name = "hand";
    hand.motion.keyframes = {{15, {0, 0, 0}}, {16, {0.1, 0, 0}}};
    scene.bodies.handles = {hand};
    scene.sheets[0].pins[0].handle = "hand";
    Simulation simulation(scene, scene.params);
    const int asleep = frames_until_asleep(simulation);
    ASSERT_LT(asleep, 15 * 60 - 1);
    const std::vector<glm::vec4> at_rest = simulation.state().positions;
    while (simulation.frame() < 15 * 60 - 1) ASSERT_EQ(simulation.advance_frame().substeps, 0);
    EXPECT_EQ(largest_way(simulation.state().positions, at_rest), 0);
    while (simulation.frame() < 16 * 60) simulation.advance_frame();
    EXPECT_GT(largest_way(simulation.state().positions, at_rest), 0.05);
}

TEST(Sleep, ends_when_a_hand_moves_a_body_and_comes_again_where_it_is_left)
{
    Scene scene = hanging_sheet();
    scene.bodies.spheres.push_back({{5, 0, 0}, 0.1f, {}});
    Simulation simulation(scene, scene.params);
    ASSERT_LT(frames_until_asleep(simulation), kLongFrames);
    simulation.hold_body(0, {0, 1, 0});
    EXPECT_GT(simulation.advance_frame().substeps, 0);
    simulation.release_body();
    EXPECT_LT(frames_until_asleep(simulation), kLongFrames);
}

TEST(Sleep, does_not_come_while_the_wind_changes)
{
    Scene scene = hanging_sheet();
    scene.params.wind_strength = 1e-5f;
    Simulation simulation(scene, scene.params);
    EXPECT_EQ(frames_until_asleep(simulation), kLongFrames) << "a breath that moves nothing further than the threshold";
}

}  // namespace
}  // namespace nuno
