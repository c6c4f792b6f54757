// Shapes of bodies against closed forms, contact with friction, and motion along keyframes.
#include "model/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "model/body_steps.h"
#include "model/formulas.h"
#include "support/body_meshes.h"
#include "support/sheets.h"

namespace nuno {
namespace {

using formulas_f64::Surface;

constexpr double kPi = glm::pi<double>();

glm::dvec3 random_point(std::mt19937& random, double size)
{
    std::uniform_real_distribution<double> at(-size, size);
    const double x = at(random), y = at(random);
    return {x, y, at(random)};
}

TEST(Surface, of_a_plane_is_the_signed_height)
{
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, -2));
    const Surface s = formulas_f64::plane_surface({0.3, -0.1, 0.7}, n);
    EXPECT_NEAR(s.distance, glm::dot(n, glm::dvec3(0.3, -0.1, 0.7)), 1e-15);
    EXPECT_EQ(s.normal, n);
}

TEST(Surface, of_a_sphere_is_the_distance_from_its_centre_less_its_radius)
{
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 d = random_point(random, 2);
        const Surface s = formulas_f64::sphere_surface(d, 0.7, {0, 1, 0});
        EXPECT_NEAR(s.distance, glm::length(d) - 0.7, 1e-14);
        EXPECT_LE(glm::distance(s.normal, glm::normalize(d)), 1e-14);
    }
    EXPECT_EQ(formulas_f64::sphere_surface({0, 0, 0}, 0.7, {0, 1, 0}).normal, glm::dvec3(0, 1, 0)) << "at the centre";
}

TEST(Surface, of_a_capsule_is_the_distance_from_its_line_less_its_radius)
{
    std::mt19937 random(2);
    const glm::dvec3 y = glm::normalize(glm::dvec3(1, 3, 2)), x = glm::normalize(glm::cross(y, glm::dvec3(0, 0, 1)));
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 d = random_point(random, 2);
        double nearest = 1e9;  // brute force over the line
        for (int k = 0; k <= 2000; ++k) nearest = std::min(nearest, glm::distance(d, (k / 1000.0 - 1) * 0.8 * y));
        const Surface s = formulas_f64::capsule_surface(d, x, y, 0.8, 0.3);
        // A step of 8e-4 along the line misses the nearest point by half of it: (4e-4)^2 / (2 distance).
        EXPECT_NEAR(s.distance, nearest - 0.3, 8e-8 / std::max(nearest, 1e-3) + 1e-12);
        EXPECT_NEAR(glm::length(s.normal), 1, 1e-14);
        const glm::dvec3 foot = d - (s.distance + 0.3) * s.normal;
        EXPECT_LE(glm::distance(foot, glm::clamp(glm::dot(d, y), -0.8, 0.8) * y), 1e-13);
    }
    EXPECT_EQ(formulas_f64::capsule_surface({0, 0, 0}, x, y, 0.8, 0.3).normal, x) << "on the line";
}

TEST(Surface, of_a_box_is_nearest_point_outside_and_nearest_face_inside)
{
    std::mt19937 random(3);
    const glm::dvec3 half(0.5, 0.8, 0.3);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 q = random_point(random, 1.2);
        const Surface s = formulas_f64::box_surface(q, half);
        const glm::dvec3 nearest = glm::clamp(q, -half, half);
        const double outside = glm::distance(q, nearest);
        if (outside > 0) {
            EXPECT_NEAR(s.distance, outside, 1e-14);
            EXPECT_LE(glm::distance(s.normal, (q - nearest) / outside), 1e-12);
        } else {
            const glm::dvec3 depth = half - glm::abs(q);
            EXPECT_NEAR(s.distance, -std::min({depth.x, depth.y, depth.z}), 1e-14);
            const glm::dvec3 onto = q - s.distance * s.normal;  // the nearest face's plane
            EXPECT_NEAR(std::max({std::abs(onto.x) / half.x, std::abs(onto.y) / half.y, std::abs(onto.z) / half.z}), 1,
                        1e-14);
        }
    }
}

formulas_f64::Contact against_floor(glm::dvec3 x, glm::dvec3 v, double friction, double h = 0)
{
    const Surface s = formulas_f64::plane_surface(x, {0, 1, 0});
    return formulas_f64::push_out(x - h * v, {x, v}, s, {0, 0, 0}, {friction, friction}, h);
}

TEST(PushOut, puts_a_particle_back_and_takes_its_inward_velocity)
{
    // 0.1 m inside the half-space, falling at 2 m/s and sliding at 3 m/s, mu 0.5: the slide loses 0.5 * 2.
    const auto c = against_floor({0, -0.1, 0}, {3, -2, 0}, 0.5);
    EXPECT_NEAR(c.motion.position.y, 0, 1e-15);
    EXPECT_NEAR(c.motion.velocity.y, 0, 1e-15);
    EXPECT_NEAR(c.motion.velocity.x, 2, 1e-12);
    EXPECT_EQ(c.sticks, 0);
}

TEST(PushOut, friction_stops_and_undoes_the_way_but_never_reverses)
{
    const auto c = against_floor({0.003, -0.02, 0}, {0.3, -2, 0}, 0.5, 0.01);
    EXPECT_EQ(c.motion.velocity.x, 0);
    EXPECT_NEAR(c.motion.position.x, 0, 1e-15);
    EXPECT_EQ(c.sticks, 1);
}

TEST(PushOut, static_friction_holds_what_kinetic_friction_would_let_slide)
{
    // |across| = 0.8 of what is lost: more than the kinetic 0.5, less than the static 1.
    const Surface s = formulas_f64::plane_surface({0, -0.1, 0}, {0, 1, 0});
    const formulas_f64::Motion m{{0, -0.1, 0}, {0.8, -1, 0}};
    EXPECT_EQ(formulas_f64::push_out({0, 0, 0}, m, s, {0, 0, 0}, {0.5, 1}, 0).motion.velocity.x, 0);
    EXPECT_NEAR(formulas_f64::push_out({0, 0, 0}, m, s, {0, 0, 0}, {0.5, 0.7}, 0).motion.velocity.x, 0.3, 1e-14);
}

TEST(PushOut, leaves_alone_what_is_outside_or_leaving)
{
    const auto outside = against_floor({0, 1, 0}, {1, -5, 0}, 0.5);
    EXPECT_EQ(outside.motion.position.y, 1);
    EXPECT_EQ(outside.motion.velocity.y, -5);
    const auto leaving = against_floor({0, -0.1, 0}, {1, 5, 0}, 0.5);
    EXPECT_NEAR(leaving.motion.position.y, 0, 1e-15);
    EXPECT_EQ(leaving.motion.velocity, glm::dvec3(1, 5, 0));
}

TEST(PushOut, a_moving_body_carries_what_sticks_to_it)
{
    const double h = 0.01;
    const Surface s = formulas_f64::plane_surface({0, -0.001, 0}, {0, 1, 0});
    const auto c = formulas_f64::push_out({0, 0, 0}, {{0, -0.001, 0}, {0, -0.1, 0}}, s, {0.05, 0.2, 0}, {1, 1}, h);
    EXPECT_NEAR(c.motion.velocity.x, 0.05, 1e-15);
    EXPECT_NEAR(c.motion.velocity.y, 0.2, 1e-15);
    EXPECT_NEAR(c.motion.position.x, 0.05 * h, 1e-15);
}

BodyMotion quarter_turn(Easing easing)
{
    BodyMotion motion;
    motion.keyframes = {{1, {0, 0, 0}, {0, 1, 0}, 0}, {3, {2, 0, 0}, {0, 1, 0}, kPi / 2}};
    motion.easing = easing;
    return motion;
}

TEST(BodyMotion, holds_before_the_first_keyframe_and_after_the_last)
{
    const BodyMotion motion = quarter_turn(Easing::smooth);
    EXPECT_EQ(displacement_at(motion, 0.3).move.x, 0);
    EXPECT_EQ(displacement_at(motion, 9).move.x, 2);
    EXPECT_NEAR(pose_at(motion, {}, 9).rotation[0].z, -1, 1e-15);
    EXPECT_EQ(displacement_at({}, 5).move, glm::dvec3(0));
}

TEST(BodyMotion, runs_evenly_or_by_the_cubic_that_rests_in_the_keyframes)
{
    EXPECT_NEAR(displacement_at(quarter_turn(Easing::linear), 1.5).move.x, 0.5, 1e-15);
    // 3 s^2 - 2 s^3 at s = 1/4 is 5/32.
    const BodyMotion smooth = quarter_turn(Easing::smooth);
    EXPECT_NEAR(displacement_at(smooth, 1.5).move.x, 2 * 5.0 / 32, 1e-15);
    EXPECT_NEAR(displacement_at(smooth, 2).move.x, 1, 1e-15);
    for (const double t : {1.0, 3.0}) {
        const double e = 1e-4;
        EXPECT_NEAR((displacement_at(smooth, t + e).move.x - displacement_at(smooth, t - e).move.x) / e, 0, 1e-3);
    }
}

TEST(BodyMotion, turns_about_its_pivot)
{
    BodyMotion motion = quarter_turn(Easing::linear);
    motion.pivot = glm::dvec3(1, 0, 0);
    const Pose pose = pose_at(motion, {{2, 5, 0}, glm::dmat3(1)}, 3);
    // (1, 5, 0) from the pivot, a quarter turn about y: (0, 5, -1); then 2 m along x.
    EXPECT_LE(glm::distance(pose.position, glm::dvec3(3, 5, -1)), 1e-14);
}

TEST(BodyMotion, makes_many_turns_about_one_axis_and_takes_the_short_way_about_two)
{
    BodyMotion motion;
    motion.easing = Easing::linear;
    motion.keyframes = {{0, {}, {0, 0, 1}, 0}, {2, {}, {0, 0, 1}, 4 * kPi}};
    EXPECT_NEAR(pose_at(motion, {}, 0.25).rotation[0].y, 1, 1e-14) << "a quarter of the first turn";
    EXPECT_NEAR(pose_at(motion, {}, 0.5).rotation[0].x, -1, 1e-14);
    motion.keyframes = {{0, {}, {1, 0, 0}, kPi / 2}, {1, {}, {0, 1, 0}, kPi / 2}};
    const glm::dquat half = displacement_at(motion, 0.5).rotation;
    const glm::dquat a = rotation_about({1, 0, 0}, kPi / 2), b = rotation_about({0, 1, 0}, kPi / 2);
    EXPECT_NEAR(glm::dot(half, a), glm::dot(half, b), 1e-14);
    EXPECT_NEAR(glm::length(half), 1, 1e-14);
}

TEST(BodyMotion, a_shift_is_added_evenly_between_its_times)
{
    BodyMotion motion;
    EXPECT_FALSE(motion.moves());
    motion.shift = {.from_s = 1, .to_s = 3, .from = {1, 0, 0}, .to = {3, 4, 0}};
    EXPECT_TRUE(motion.moves());
    const Pose rest{{0, 10, 0}, glm::dmat3(1)};
    const auto place = [&](double time_s) { return pose_at(motion, rest, time_s).position; };
    EXPECT_EQ(place(0), glm::dvec3(1, 10, 0));
    EXPECT_EQ(place(2), glm::dvec3(2, 12, 0));
    EXPECT_EQ(place(5), glm::dvec3(3, 14, 0));
    motion.keyframes = {{0, {0, 0, 0}}, {4, {0, 0, 8}}};
    motion.easing = Easing::linear;
    EXPECT_EQ(place(2), glm::dvec3(2, 12, 4));
}

TEST(BodySteps, follow_a_shift_that_begins_and_ends)
{
    ClothModel model;
    Bodies bodies;
    bodies.spheres.emplace_back();
    BodySteps steps(bodies, model);
    steps.plan(0, 0.1, 4);
    EXPECT_EQ(steps.bodies(3)[0].position.x, 0.0f);
    bodies.spheres[0].motion.shift = {.from_s = 0.4, .to_s = 0.8, .from = {0, 0, 0}, .to = {2, 0, 0}};
    steps.plan(0.4, 0.1, 4);
    EXPECT_FLOAT_EQ(steps.bodies(1)[0].position.x, 1.0f);
    EXPECT_FLOAT_EQ(steps.bodies(1)[0].velocity[0].w, 5.0f);
    bodies.spheres[0].motion.shift = {};
    steps.plan(0.8, 0.1, 4);
    EXPECT_EQ(steps.bodies(3)[0].position.x, 0.0f) << "as it was before";
}

TEST(BodyMotion, repeats)
{
    BodyMotion motion = quarter_turn(Easing::linear);
    motion.keyframes.push_back({5, {0, 0, 0}, {0, 1, 0}, 0});
    motion.repeat = true;
    for (const double t : {0.2, 1.5, 2.7, 4.1}) {
        EXPECT_NEAR(displacement_at(motion, t + (t < 1 ? 0 : 4)).move.x, displacement_at(motion, t).move.x, 1e-14);
        EXPECT_NEAR(displacement_at(motion, 400 + 1 + t).move.x, displacement_at(motion, 1 + t).move.x, 1e-12);
    }
}

TEST(BodySteps, velocities_are_the_way_of_each_point_over_the_substep)
{
    Bodies bodies;
    bodies.boxes.push_back({{0.5f, 1, -0.3f}, {1, 2, 3}, {}, quarter_turn(Easing::smooth)});
    bodies.boxes[0].motion.pivot = glm::dvec3(0, 0, 1);
    const ClothModel model = square_cloth(3, 1);
    BodySteps steps(bodies, model);
    const double h = 1e-2, start = 1.7;
    steps.plan(start, h, 3);
    const PlacedBody body = placed_bodies(bodies)[0];
    for (int k = 0; k < 3; ++k) {
        const BodyStep& step = steps.bodies(k)[0];
        const Pose before = pose_at(*body.motion, body.rest, start + k * h);
        const Pose after = pose_at(*body.motion, body.rest, start + (k + 1) * h);
        const glm::dvec3 local(0.3, -0.7, 1.1), x0 = before.rotation * local + before.position;
        const auto row = [&](int i) { return glm::vec3(step.velocity[i]); };
        const glm::vec3 u = formulas::velocity_of_body(glm::vec3(x0), glm::vec3(step.origin), row(0), row(1), row(2),
                                                       {step.velocity[0].w, step.velocity[1].w, step.velocity[2].w});
        const glm::dvec3 expected = (after.rotation * local + after.position - x0) / h;
        EXPECT_LE(glm::distance(glm::dvec3(u), expected), 1e-6 * glm::length(expected));
        EXPECT_LE(glm::distance(glm::dvec3(step.position), after.position), 1e-6);
    }
}

TEST(BodySteps, a_body_at_rest_has_no_velocity_at_all)
{
    Bodies bodies;
    bodies.boxes.push_back({{5, 1, -3}, {1, 1, 1}, glm::quat(0.3f, 0.2f, -0.5f, 0.8f), {}});
    bodies.spheres.push_back({{0, 0, 0}, 1, quarter_turn(Easing::linear)});
    const ClothModel model = square_cloth(3, 1);
    BodySteps steps(bodies, model);
    steps.plan(2, 1e-3, 1);
    EXPECT_NE(steps.bodies(0)[0].velocity[0].w, 0) << "the sphere comes first and moves";
    for (const glm::vec4& row : steps.bodies(0)[1].velocity) EXPECT_EQ(row, glm::vec4(0));
}

TEST(BodySteps, grids_begin_where_their_bodies_say_whatever_their_sizes)
{
    Bodies bodies;
    for (const float cell : {0.031f, 0.04f, 0.05f}) {
        const TriangleMesh mesh = dented_box_mesh({0.3f, 0.2f, 0.25f}, 0.1f);
        bodies.meshes.push_back(
            {.mesh = mesh, .grid = std::make_shared<DistanceGrid>(make_distance_grid(mesh, cell, "mesh"))});
    }
    const ClothModel model = square_cloth(3, 1);
    BodySteps steps(bodies, model);
    steps.plan(0, 1e-3, 1);
    const std::vector<float> numbers = steps.grid_numbers();
    for (std::size_t body = 0; body < bodies.meshes.size(); ++body) {
        const DistanceGrid& grid = *bodies.meshes[body].grid;
        const auto start = BodySteps::kGridHeader * static_cast<std::size_t>(steps.bodies(0)[body].origin.w);
        ASSERT_LE(start + BodySteps::kGridHeader + grid.values.size(), numbers.size());
        EXPECT_EQ(numbers[start + 3], grid.cell);
        EXPECT_EQ(numbers[start + BodySteps::kGridHeader], grid.values.front());
        EXPECT_EQ(numbers[start + BodySteps::kGridHeader + grid.values.size() - 1], grid.values.back());
    }
}

TEST(BodySteps, the_ball_around_a_body_holds_all_of_it)
{
    Bodies bodies;
    bodies.spheres.push_back({{1, 2, 3}, 0.5f, {}});
    bodies.capsules.push_back({{0, 0, 0}, {0, 0, 2}, 0.25f, {}});
    bodies.boxes.push_back({{0, 1, 0}, {2, 4, 6}, glm::quat(1, 0, 0, 0), {}});
    const TriangleMesh mesh = dented_box_mesh({0.3f, 0.2f, 0.25f}, 0.1f);
    bodies.meshes.push_back(
        {.mesh = mesh, .grid = std::make_shared<DistanceGrid>(make_distance_grid(mesh, 0.03f, "mesh"))});
    const ClothModel model = square_cloth(3, 1);
    BodySteps steps(bodies, model);
    steps.plan(0, 1e-3, 1);
    EXPECT_FLOAT_EQ(steps.bound(0), 0.5f);
    EXPECT_FLOAT_EQ(steps.bound(1), 1.25f);
    EXPECT_FLOAT_EQ(steps.bound(2), std::sqrt(1.0f + 4.0f + 9.0f));
    for (const glm::vec3& vertex : mesh.positions) EXPECT_GE(steps.bound(3), glm::length(vertex));
    // Kernels read it of boxes and meshes.
    for (std::size_t body : {2, 3}) EXPECT_EQ(steps.bodies(0)[body].position.w, steps.bound(body));
}

TEST(BodySteps, pins_follow_their_handle)
{
    Bodies bodies;
    bodies.handles.push_back({"left", {}});
    bodies.handles.push_back({"right", quarter_turn(Easing::linear)});
    SheetSource sheet = square_sheet(3, 1, {4});
    sheet.handle_pins = {{2, 1}, {0, 0}};
    const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
    EXPECT_TRUE(model.pinned[0] && model.pinned[2] && model.pinned[4] && !model.pinned[1]);
    BodySteps steps(bodies, model);
    steps.plan(2.9, 0.1, 2);
    ASSERT_EQ(steps.pins().size(), 2u);
    EXPECT_EQ(steps.pins()[0].vertex, 0u);
    EXPECT_EQ(glm::vec3(steps.pin_steps(1)[0].position), model.start_positions[0]);
    // (1, 0, 0) turned by a quarter about y, then moved by 2: (2, 0, -1); at rest after the last keyframe.
    EXPECT_LE(glm::distance(glm::vec3(steps.pin_steps(1)[1].position), glm::vec3(2, 0, -1)), 1e-6f);
    EXPECT_EQ(glm::vec3(steps.pin_steps(1)[1].velocity), glm::vec3(0));
    // x = 1 (t - 1) + cos(a), a = (t - 1) pi/4, in the middle of the substep; its third derivative times h^2 / 24 off.
    EXPECT_NEAR(steps.pin_steps(0)[1].velocity.x, 1 - kPi / 4 * std::sin(1.95 * kPi / 4), 3e-4);
}

}  // namespace
}  // namespace nuno
