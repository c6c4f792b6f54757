// Camera geometry; y is up.
#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nuno {
namespace {

glm::vec3 target_of(const ViewParams& params)
{
    return {params.camera_target_x, params.camera_target_y, params.camera_target_z};
}

// Keeps a value that the mouse moves within the range of its parameter.
float in_range(std::string_view name, float value)
{
    const ParamInfo* info = find_param(view_param_table(), name);
    return std::clamp(value, static_cast<float>(info->min), static_cast<float>(info->max));
}

void set_target(ViewParams& params, glm::vec3 target)
{
    params.camera_target_x = in_range("camera_target_x", target.x);
    params.camera_target_y = in_range("camera_target_y", target.y);
    params.camera_target_z = in_range("camera_target_z", target.z);
}

}  // namespace

Camera make_camera(const ViewParams& params, float aspect)
{
    const float azimuth = glm::radians(params.camera_azimuth);
    const float elevation = glm::radians(params.camera_elevation);
    const glm::vec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                         std::cos(azimuth) * std::cos(elevation));
    Camera camera;
    camera.eye = target_of(params) + params.camera_distance * back;
    camera.forward = -back;
    camera.right = glm::vec3(std::cos(azimuth), 0, -std::sin(azimuth));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.tan_half_height = std::tan(0.5f * glm::radians(params.field_of_view));
    camera.aspect = aspect;
    const float near = 0.02f * params.camera_distance;
    camera.view_projection = glm::infinitePerspective(glm::radians(params.field_of_view), aspect, near) *
                             glm::lookAt(camera.eye, camera.eye + camera.forward, camera.up);
    return camera;
}

Ray ray_through(const Camera& camera, glm::vec2 pixel, glm::vec2 size)
{
    const float x = 2 * pixel.x / size.x - 1;
    const float y = 1 - 2 * pixel.y / size.y;
    const glm::vec3 direction = camera.forward + x * camera.tan_half_height * camera.aspect * camera.right +
                                y * camera.tan_half_height * camera.up;
    return {camera.eye, glm::normalize(direction)};
}

void orbit(ViewParams& params, glm::vec2 pixels, float height)
{
    const float degrees_per_pixel = 180 / height;
    params.camera_azimuth = std::remainder(params.camera_azimuth - pixels.x * degrees_per_pixel, 360.0f);
    params.camera_elevation = in_range("camera_elevation", params.camera_elevation + pixels.y * degrees_per_pixel);
}

void pan(ViewParams& params, glm::vec2 pixels, float height)
{
    const Camera camera = make_camera(params, 1);
    const float metres_per_pixel = 2 * params.camera_distance * camera.tan_half_height / height;
    set_target(params, target_of(params) + metres_per_pixel * (pixels.y * camera.up - pixels.x * camera.right));
}

void zoom(ViewParams& params, float notches)
{
    params.camera_distance = in_range("camera_distance", params.camera_distance * std::pow(0.9f, notches));
}

void frame_box(ViewParams& params, glm::vec3 low, glm::vec3 high, float aspect)
{
    const float radius = std::max(0.5f * glm::length(high - low), 0.001f);
    const float half_height = 0.5f * glm::radians(params.field_of_view);
    const float half_width = std::atan(std::tan(half_height) * aspect);
    set_target(params, 0.5f * (low + high));
    params.camera_distance = in_range("camera_distance", radius / std::sin(std::min(half_height, half_width)));
}

}  // namespace nuno
