// Picking and dragging: what is under the pointer, and where it goes.
#include "app/vertex_picker.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include <glm/geometric.hpp>

#include "app/body_picker.h"
#include "app/point_drag.h"
#include "model/cloth_model.h"

namespace nuno {
namespace {

constexpr glm::vec2 kWindow(800, 600);
constexpr float kReach = 20;

// The default view straight onto a plane z = constant.
PickView front_view()
{
    ViewParams params;
    params.camera_azimuth = params.camera_elevation = 0;
    return {make_camera(params, kWindow.x / kWindow.y), kWindow};
}

// A grid of 5 x 5 vertices, 1 m wide, around the camera's target, `z` in front of it.
struct Sheet5
{
    explicit Sheet5(float z)
    {
        const TriangleMesh mesh = grid_mesh(5, 5, {-0.5f, 0.9f, z}, {1, 0, 0}, {0, -1, 0});
        faces = mesh.faces;
        for (const glm::vec3& position : mesh.positions) positions.emplace_back(position, 1);
    }
    std::vector<glm::vec4> positions;
    std::vector<glm::uvec3> faces;
};

glm::vec2 place_of(const PickView& view, const glm::vec4& position)
{
    return glm::vec2(project(view, glm::vec3(position)).value());
}

TEST(VertexPicker, the_target_of_the_camera_is_projected_to_the_middle_of_the_window)
{
    const glm::vec3 seen = project(front_view(), {0, 0.4f, 0}).value();
    EXPECT_NEAR(seen.x, 400, 0.01);
    EXPECT_NEAR(seen.y, 300, 0.01);
    EXPECT_FALSE(project(front_view(), {0, 0.4f, 100}).has_value()) << "behind the camera";
}

TEST(VertexPicker, a_ray_through_a_projected_point_meets_the_point)
{
    ViewParams params;
    const PickView view{make_camera(params, kWindow.x / kWindow.y), kWindow};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> near(-0.5f, 0.5f);
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 point(near(random), 0.4f + near(random), near(random));
        const Ray ray = ray_through(view.camera, glm::vec2(project(view, point).value()), kWindow);
        EXPECT_LT(glm::length(glm::cross(point - ray.origin, ray.direction)), 1e-4f);
    }
}

TEST(VertexPicker, every_vertex_is_found_at_its_own_place)
{
    const Sheet5 sheet(0);
    const PickView view = front_view();
    for (std::uint32_t v = 0; v < sheet.positions.size(); ++v)
        EXPECT_EQ(pick_vertex(sheet.positions, sheet.faces, view, place_of(view, sheet.positions[v]), kReach), v);
}

TEST(VertexPicker, inside_a_face_the_nearest_corner_is_taken_however_far_it_is)
{
    const Sheet5 sheet(0);
    const PickView view = front_view();
    const glm::vec2 corner = place_of(view, sheet.positions[12]), next = place_of(view, sheet.positions[13]);
    const glm::vec2 between = corner + 0.4f * (next - corner) + glm::vec2(0, 1);
    EXPECT_GT(glm::distance(between, corner), kReach);
    EXPECT_EQ(pick_vertex(sheet.positions, sheet.faces, view, between, kReach), 12u);
}

TEST(VertexPicker, beside_the_cloth_only_what_is_within_reach_is_taken)
{
    const Sheet5 sheet(0);
    const PickView view = front_view();
    const glm::vec2 left = place_of(view, sheet.positions[10]);
    EXPECT_EQ(pick_vertex(sheet.positions, sheet.faces, view, left - glm::vec2(kReach - 1, 0), kReach), 10u);
    EXPECT_FALSE(pick_vertex(sheet.positions, sheet.faces, view, left - glm::vec2(kReach + 1, 0), kReach));
}

TEST(VertexPicker, of_two_layers_the_front_one_is_taken)
{
    const Sheet5 back(0), front(0.3f);
    const PickView view = front_view();
    std::vector<glm::vec4> positions = back.positions;
    positions.insert(positions.end(), front.positions.begin(), front.positions.end());
    std::vector<glm::uvec3> faces = back.faces;
    for (const glm::uvec3& face : front.faces) faces.push_back(face + 25u);
    EXPECT_EQ(pick_vertex(positions, faces, view, place_of(view, back.positions[12]), kReach), 37u);
}

TEST(VertexPicker, cloth_behind_the_camera_is_never_taken)
{
    const Sheet5 sheet(50);
    EXPECT_FALSE(pick_vertex(sheet.positions, sheet.faces, front_view(), {400, 300}, 1e6f));
}

TEST(BodyPicker, takes_the_frontmost_body_as_it_is_drawn_but_no_plane)
{
    const PickView view = front_view();
    Bodies bodies;
    bodies.planes.push_back({{0, 0, 1}, 0.5f, {}});
    bodies.spheres.push_back({{0, 0, 0}, 0.2f, {}});
    bodies.boxes.push_back({{0, 0, -1}, {1, 1, 0.2f}, {1, 0, 0, 0}, {}});
    const glm::vec2 middle = place_of(view, glm::vec4(0, 0, 0, 1));
    const auto ball = pick_body(bodies, 0, view, middle);
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->body, 1u);
    const glm::vec3 point = unproject(view, glm::vec3(middle, ball->depth));
    EXPECT_NEAR(glm::length(point), 0.2, 0.01) << "on its surface";
    EXPECT_GT(glm::dot(point, view.camera.eye), 0) << "on the side of the camera";
    const glm::vec2 beside = place_of(view, glm::vec4(0.35f, 0, 0, 1));
    EXPECT_EQ(pick_body(bodies, 0, view, beside).value().body, 2u);
    EXPECT_FALSE(pick_body(bodies, 0, view, place_of(view, glm::vec4(2, 0, 0, 1))));
    bodies.spheres[0].motion.shift = {.to = {0.35, 0, 0}};
    EXPECT_EQ(pick_body(bodies, 1, view, beside).value().body, 1u) << "where it is now";
    EXPECT_EQ(pick_body(bodies, 1, view, middle).value().body, 2u);
}

TEST(VertexPicker, a_body_hides_what_is_behind_it_and_has_no_reach_around_it)
{
    const Sheet5 sheet(0);
    const PickView view = front_view();
    const glm::vec2 place = place_of(view, sheet.positions[12]);
    const float depth = project(view, glm::vec3(sheet.positions[12])).value().z;
    EXPECT_FALSE(pick_vertex(sheet.positions, sheet.faces, view, place, kReach, depth - 0.001f));
    EXPECT_EQ(pick_vertex(sheet.positions, sheet.faces, view, place, kReach, depth + 0.001f), 12u);
    const glm::vec2 left = place_of(view, sheet.positions[10]) - glm::vec2(kReach / 2, 0);
    EXPECT_FALSE(pick_vertex(sheet.positions, sheet.faces, view, left, kReach, 1.0f));
}

TEST(PointDrag, keeps_the_offset_to_the_pointer_and_the_distance_to_the_screen)
{
    const PickView view = front_view();
    const glm::vec3 start(0.1f, 0.5f, 0.2f);
    const glm::vec2 pointer = glm::vec2(project(view, start).value()) + glm::vec2(7, -5);
    PointDrag drag(start, view.camera.forward, ray_through(view.camera, pointer, kWindow));
    EXPECT_LT(glm::distance(drag.target(), start), 1e-6f) << "taking it moves nothing";
    drag.follow(ray_through(view.camera, pointer + glm::vec2(60, 30), kWindow));
    EXPECT_NEAR(glm::dot(drag.target() - start, view.camera.forward), 0, 1e-5);
    const glm::vec2 way = glm::vec2(project(view, drag.target()).value()) - glm::vec2(project(view, start).value());
    EXPECT_NEAR(way.x, 60, 0.05);
    EXPECT_NEAR(way.y, 30, 0.05);
}

TEST(PointDrag, stays_where_it_is_when_the_pointer_misses_its_plane)
{
    const PickView view = front_view();
    PointDrag drag({0, 0.4f, 0}, view.camera.forward, ray_through(view.camera, {400, 300}, kWindow));
    drag.follow({view.camera.eye, -view.camera.forward});
    EXPECT_EQ(drag.target(), glm::vec3(0, 0.4f, 0));
    drag.follow({view.camera.eye, view.camera.right});
    EXPECT_EQ(drag.target(), glm::vec3(0, 0.4f, 0));
}

}  // namespace
}  // namespace nuno
