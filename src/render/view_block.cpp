// Light, colours and floor of a picture, from its parameters.
#include "render/view_block.h"

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nuno {
namespace {

// Colours as 0xRRGGBB in sRGB.
struct Palette
{
    std::uint32_t zenith, horizon, nadir;  // background
    std::uint32_t sky, ground;             // tint of the light from above and from below
    std::uint32_t tile_light, tile_dark, body;
};

Palette palette_of(Background background)
{
    switch (background) {
    case Background::studio: return {0xaab4be, 0xe6e7e6, 0xc4c3c0, 0xf2f5ff, 0xb0a698, 0xdfdcd6, 0xd2cec7, 0xb9866a};
    case Background::daylight: return {0x6fa3d8, 0xe3ecf2, 0xb9b6ab, 0xdcecff, 0xb3a68c, 0xd8d3c4, 0xc9c3b2, 0xb9866a};
    case Background::night: return {0x12151c, 0x333a47, 0x16181d, 0xa9bce6, 0x555a68, 0x4a505b, 0x3f444e, 0x8f6a58};
    }
    return {};
}

float linear_of(std::uint32_t code)
{
    const float c = static_cast<float>(code & 0xff) / 255.0f;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

glm::vec4 linear_colour(std::uint32_t rgb) { return {linear_of(rgb >> 16), linear_of(rgb >> 8), linear_of(rgb), 1}; }

glm::vec3 direction_of(float azimuth_deg, float elevation_deg)
{
    const float azimuth = glm::radians(azimuth_deg), elevation = glm::radians(elevation_deg);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

void set_lights(ViewBlock& block, const ViewParams& params, const Palette& palette)
{
    block.key_direction = glm::vec4(key_direction(params), 0);
    block.key_light = glm::vec4(params.key_light * glm::vec3(1.0f, 0.97f, 0.92f), params.translucency);
    // From the other side, so that what the key light leaves dark is seen.
    block.fill_direction = glm::vec4(direction_of(params.light_azimuth + 115, 15), 0);
    block.fill_light = params.fill_light * glm::vec4(0.88f, 0.94f, 1.0f, 0);
    block.sky_light = params.ambient * linear_colour(palette.sky);
    block.ground_light = params.ambient * linear_colour(palette.ground);
}

void set_floor(ViewBlock& block, const ViewParams& params, const Plane& floor)
{
    const glm::vec3 n = floor.normal;
    const glm::vec3 target(params.camera_target_x, params.camera_target_y, params.camera_target_z);
    const float height = glm::dot(n, target) - floor.offset;
    // Along x and z where the floor is level.
    const glm::vec3 across =
        glm::normalize(std::abs(n.x) < 0.9f ? glm::vec3(1, 0, 0) - n.x * n : glm::cross(n, glm::vec3(0, 0, 1)));
    const float fade = 3 * params.camera_distance;
    block.floor_plane = glm::vec4(n, floor.offset);
    block.floor_centre = glm::vec4(target - height * n, fade);
    block.floor_across = glm::vec4(across, 3 * fade);
    block.floor_along = glm::vec4(glm::cross(n, across), 0);
    const glm::vec3 light(block.key_direction);
    const float slope = glm::dot(n, light);
    // A light that grazes the floor, or comes from under it, throws no shadow that fits.
    const bool shadow = params.shadow && slope > 0.1f;
    block.shadow_centre =
        shadow ? glm::vec4(target - height / slope * light, 1.2f * params.camera_distance) : glm::vec4(0);
}

}  // namespace

glm::vec3 key_direction(const ViewParams& params) { return direction_of(params.light_azimuth, params.light_elevation); }

ViewBlock make_view_block(const ViewParams& params, const Camera& camera, const Plane& floor)
{
    const Palette palette = palette_of(params.background);
    ViewBlock block;
    block.view_projection = camera.view_projection;
    block.eye = glm::vec4(camera.eye, 0);
    block.ray_right = glm::vec4(camera.tan_half_height * camera.aspect * camera.right, 0);
    block.ray_up = glm::vec4(camera.tan_half_height * camera.up, 0);
    block.ray_forward = glm::vec4(camera.forward, 0);
    block.zenith_colour = linear_colour(palette.zenith);
    block.horizon_colour = linear_colour(palette.horizon);
    block.nadir_colour = linear_colour(palette.nadir);
    block.tile_light = linear_colour(palette.tile_light);
    block.tile_dark = linear_colour(palette.tile_dark);
    block.body_colour = linear_colour(palette.body);
    set_lights(block, params, palette);
    set_floor(block, params, floor);
    return block;
}

Plane floor_of(const ViewParams& params, const Bodies& bodies, double time_s)
{
    if (bodies.planes.empty()) return {{0, 1, 0}, params.floor_height, {}};
    const Plane& plane = bodies.planes.front();
    if (!plane.motion.moves()) return plane;
    const Pose rest = placed_bodies(bodies).front().rest;
    const Pose pose = pose_at(plane.motion, rest, time_s);
    const glm::dvec3 normal = pose.rotation[1];
    return {glm::vec3(normal), static_cast<float>(glm::dot(normal, pose.position)), {}};
}

}  // namespace nuno
