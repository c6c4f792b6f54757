// The camera: rays go where pixels are drawn, and the mouse moves it as one expects.
#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr glm::vec2 kSize{1280, 720};

glm::vec3 target_of(const ViewParams& params)
{
    return {params.camera_target_x, params.camera_target_y, params.camera_target_z};
}

ViewParams some_view()
{
    ViewParams params;
    params.camera_azimuth = -130;
    params.camera_elevation = 35;
    params.camera_distance = 4;
    params.camera_target_x = 0.5f;
    params.camera_target_z = -2;
    return params;
}

glm::vec2 pixel_of(const Camera& camera, glm::vec3 point)
{
    const glm::vec4 clip = camera.view_projection * glm::vec4(point, 1);
    return kSize * (0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w);
}

TEST(Camera, the_ray_through_the_centre_meets_the_target)
{
    const ViewParams params = some_view();
    const Ray ray = ray_through(make_camera(params, kSize.x / kSize.y), 0.5f * kSize, kSize);
    EXPECT_LT(glm::distance(ray.origin + params.camera_distance * ray.direction, target_of(params)), 1e-5f);
}

TEST(Camera, a_point_on_the_ray_through_a_pixel_is_drawn_there)
{
    const Camera camera = make_camera(some_view(), kSize.x / kSize.y);
    for (const glm::vec2 pixel : {glm::vec2(3, 700), glm::vec2(1279, 1), glm::vec2(200.5f, 333.25f)}) {
        const Ray ray = ray_through(camera, pixel, kSize);
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
        EXPECT_LT(glm::distance(pixel_of(camera, ray.origin + 3.0f * ray.direction), pixel), 0.01f);
    }
}

TEST(Camera, nearer_points_have_less_depth_and_all_have_some)
{
    const Camera camera = make_camera(some_view(), 1);
    const auto depth = [&](float distance) {
        const glm::vec4 clip = camera.view_projection * glm::vec4(camera.eye + distance * camera.forward, 1);
        return clip.z / clip.w;
    };
    EXPECT_LT(depth(1), depth(4));
    EXPECT_LT(depth(4), depth(1e5f));
    EXPECT_LE(depth(1e5f), 1.0f);
    EXPECT_GT(depth(0.1f), -1.0f);
}

TEST(Camera, orbiting_keeps_distance_and_target)
{
    ViewParams params = some_view();
    orbit(params, {170, -60}, kSize.y);
    EXPECT_NEAR(glm::distance(make_camera(params, 1).eye, target_of(params)), 4.0f, 1e-5f);
    EXPECT_EQ(target_of(params), target_of(some_view()));
}

TEST(Camera, orbiting_never_leaves_the_ranges_of_its_parameters)
{
    ViewParams params = some_view();
    for (int i = 0; i < 50; ++i) orbit(params, {400, 300}, kSize.y);
    EXPECT_EQ(params.camera_elevation, 89.0f);
    EXPECT_GE(params.camera_azimuth, -180.0f);
    EXPECT_LE(params.camera_azimuth, 180.0f);
}

TEST(Camera, panning_moves_the_target_with_the_mouse)
{
    ViewParams params = some_view();
    const glm::vec3 before = target_of(params);
    pan(params, {120, 45}, kSize.y);
    const glm::vec2 pixel = pixel_of(make_camera(params, kSize.x / kSize.y), before);
    EXPECT_LT(glm::distance(pixel, 0.5f * kSize + glm::vec2(120, 45)), 0.05f);
}

TEST(Camera, zooming_in_and_out_comes_back)
{
    ViewParams params = some_view();
    zoom(params, 3);
    EXPECT_LT(params.camera_distance, 3.0f);
    zoom(params, -3);
    EXPECT_NEAR(params.camera_distance, 4.0f, 1e-5f);
}

TEST(Camera, a_framed_box_is_wholly_in_the_picture)
{
    ViewParams params = some_view();
    const glm::vec3 low(-3, 0, 1), high(2, 1, 1.5f);
    frame_box(params, low, high, kSize.x / kSize.y);
    const Camera camera = make_camera(params, kSize.x / kSize.y);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point(corner & 1 ? low.x : high.x, corner & 2 ? low.y : high.y, corner & 4 ? low.z : high.z);
        const glm::vec2 pixel = pixel_of(camera, point);
        EXPECT_GT(pixel.x, 0);
        EXPECT_GT(pixel.y, 0);
        EXPECT_LT(pixel.x, kSize.x);
        EXPECT_LT(pixel.y, kSize.y);
    }
}

}  // namespace
}  // namespace nuno
