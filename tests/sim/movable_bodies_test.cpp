// Bodies that a hand moves while the cloth does.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/rewind.h"
#include "sim/run_recorder.h"
#include "sim/saved_run.h"
#include "sim/saved_scene.h"

namespace nuno {
namespace {

constexpr std::size_t kBall = 0, kBox = 1;
constexpr glm::dvec3 kUp{0, 0.3, 0};

glm::dvec3 place_of(const Simulation& simulation, std::size_t body)
{
    const PlacedBody placed = placed_bodies(simulation.bodies()).at(body);
    return pose_at(*placed.motion, placed.rest, simulation.time_s()).position;
}

float lowest_over_ball(Simulation& simulation)
{
    const glm::vec3 ball(place_of(simulation, kBall));
    float nearest = 1e9f;
    for (const glm::vec4& x : simulation.state().positions)
        nearest = std::min(nearest, glm::distance(glm::vec3(x), ball));
    return nearest;
}

class Movable : public testing::Test
{
  protected:
    SavedSceneFolder files;
    Scene scene = files.scene();
};

TEST_F(Movable, a_body_follows_the_hand_no_faster_than_a_hand_and_stays_where_it_is_left)
{
    Simulation simulation(scene, scene.params), still(scene, scene.params);
    simulation.hold_body(kBox, {1, 0, 0});
    const double most = double(kHandSpeed) / double(scene.params.frame_rate);
    for (int frame = 1; frame <= 5; ++frame) {
        simulation.advance_frame();
        EXPECT_NEAR(place_of(simulation, kBox).x, frame * most, 1e-12);
    }
    advance_frames(simulation, 30);
    EXPECT_NEAR(place_of(simulation, kBox).x, 1, 1e-12) << "it is where it is wanted";
    simulation.release_body();
    advance_frames(simulation, 3);
    EXPECT_NEAR(place_of(simulation, kBox).x, 1, 1e-12);
    advance_frames(still, 38);
    EXPECT_EQ(place_of(simulation, kBall), place_of(still, kBall)) << "alone";
}

TEST_F(Movable, keyframes_go_on_under_the_hand)
{
    Simulation moved(scene, scene.params), still(scene, scene.params);
    moved.hold_body(kBall, kUp);
    for (int frame = 0; frame < 20; ++frame) moved.advance_frame(), still.advance_frame();
    const glm::dvec3 way = place_of(moved, kBall) - place_of(still, kBall);
    EXPECT_LT(glm::distance(way, kUp), 1e-12);
}

class MovableWithMethod : public testing::TestWithParam<Method>
{};

TEST_P(MovableWithMethod, a_body_pushes_the_cloth)
{
    const Scene scene = SavedSceneFolder().scene();
    SimParams params = scene.params;
    params.method = GetParam();
    if (params.method == Method::explicit_euler) params.damping = 30, params.substeps = 300;
    Simulation moved(scene, params), still(scene, params);
    moved.hold_body(kBall, kUp);
    advance_frames(moved, 20);
    advance_frames(still, 20);
    const auto height = [](Simulation& simulation) {
        float sum = 0;
        for (const glm::vec4& x : simulation.state().positions) sum += x.y;
        return sum / static_cast<float>(simulation.state().positions.size());
    };
    EXPECT_GT(height(moved), height(still) + 0.05f);
    EXPECT_GT(lowest_over_ball(moved), 0.19f) << "and does not go into it";
}

INSTANTIATE_TEST_SUITE_P(Movable, MovableWithMethod,
                         testing::Values(Method::explicit_euler, Method::symplectic_euler, Method::verlet, Method::rk4,
                                         Method::xpbd, Method::vbd, Method::implicit_euler, Method::reference,
                                         Method::sdirk2),
                         [](const auto& of) { return std::string(choice_names(Method{})[std::size_t(of.param)]); });

TEST_F(Movable, a_restart_puts_all_back_to_the_same_bits)
{
    Simulation moved(scene, scene.params), anew(scene, scene.params);
    moved.hold_body(kBall, kUp);
    advance_frames(moved, 10);
    moved.restart();
    EXPECT_EQ(place_of(moved, kBall), place_of(anew, kBall));
    advance_frames(moved, 10);
    advance_frames(anew, 10);
    EXPECT_EQ(hash_text(moved.state()), hash_text(anew.state()));
}

TEST_F(Movable, a_saved_scene_goes_on_with_the_same_bits_and_places)
{
    Simulation simulation(scene, scene.params);
    simulation.hold_body(kBall, kUp);
    advance_frames(simulation, 10);
    simulation.release_body();
    std::filesystem::create_directories(files.path() / "later");
    const auto path = files.path() / "later/moved.toml";
    save_scene(path, simulation, {});
    const Scene saved = load_scene(path.string());
    Simulation resumed(saved, saved.params);
    EXPECT_EQ(place_of(resumed, kBall), place_of(simulation, kBall));
    advance_frames(simulation, 6);
    advance_frames(resumed, 6);
    EXPECT_EQ(hash_text(resumed.state()), hash_text(simulation.state()));
    resumed.hold_body(kBall, {0, 0, 0});
    advance_frames(resumed, 6);
    resumed.restart();
    EXPECT_GT(place_of(resumed, kBall).y, 0.29) << "its start is the saved state";
}

TEST_F(Movable, frames_looked_back_at_have_the_places_of_then)
{
    Simulation simulation(scene, scene.params);
    Rewind rewind;
    rewind.keep(simulation);
    for (int frame = 0; frame < 8; ++frame) {
        if (frame == 4) simulation.hold_body(kBall, kUp);
        simulation.advance_frame();
        rewind.keep(simulation);
    }
    const std::string end = hash_text(simulation.state());
    const glm::dvec3 end_place = place_of(simulation, kBall);
    rewind.show(simulation, 4);
    EXPECT_LT(place_of(simulation, kBall).y, 0.01);
    rewind.show(simulation, 8);
    EXPECT_EQ(hash_text(simulation.state()), end);
    EXPECT_EQ(place_of(simulation, kBall), end_place);
}

TEST_F(Movable, bodies_of_a_group_move_together_and_planes_not_at_all)
{
    scene.bodies.spheres[0].motion.group = scene.bodies.boxes[0].motion.group = "both";
    scene.bodies.planes.push_back({{0, 1, 0}, -2, {}});
    Simulation simulation(scene, scene.params), still(scene, scene.params);
    simulation.hold_body(0, kUp);
    advance_frames(simulation, 3);
    EXPECT_EQ(place_of(simulation, 0), place_of(still, 0)) << "the plane";
    simulation.hold_body(1 + kBox, kUp);
    advance_frames(simulation, 10);
    advance_frames(still, 13);
    for (const std::size_t body : {1 + kBall, 1 + kBox})
        EXPECT_NEAR(place_of(simulation, body).y - place_of(still, body).y, kUp.y, 1e-12) << body;
}

TEST_F(Movable, cloth_that_is_tied_to_bodies_keeps_them_in_place)
{
    scene.bodies.spheres[0].motion = {};
    SimParams params = scene.params;
    params.method = Method::xpbd;
    params.tethers = Tethers::contacts;
    Simulation tied(scene, params);
    EXPECT_THROW(tied.hold_body(kBall, kUp), Error);
    params.tethers = Tethers::none;
    Simulation simulation(scene, params);
    simulation.hold_body(kBall, kUp);
    advance_frames(simulation, 2);
    const glm::dvec3 place = place_of(simulation, kBall);
    params.tethers = Tethers::contacts;
    EXPECT_THROW(simulation.set_params(params), Error);
    EXPECT_EQ(place_of(simulation, kBall), place);
    simulation.restart();
    EXPECT_NO_THROW(simulation.set_params(params));
}

}  // namespace
}  // namespace nuno
