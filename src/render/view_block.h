// What every program of one picture shares, as the uniform block View of shaders/render/view_block.glsl.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "model/body.h"
#include "render/camera.h"
#include "render/view_params.h"

namespace nuno {

// Only matrices and vec4, so that the layout is std140's; the fields are explained in the GLSL file.
struct ViewBlock
{
    glm::mat4 view_projection;
    glm::vec4 eye, ray_right, ray_up, ray_forward;
    glm::vec4 key_direction, key_light, fill_direction, fill_light, sky_light, ground_light;
    glm::vec4 zenith_colour, horizon_colour, nadir_colour, tile_light, tile_dark, body_colour;
    glm::vec4 floor_plane, floor_centre, floor_across, floor_along, shadow_centre;
};

// Towards the key light, of unit length.
glm::vec3 key_direction(const ViewParams& params);

// `floor`: the plane that is shown, of unit normal.
ViewBlock make_view_block(const ViewParams& params, const Camera& camera, const Plane& floor);

// The first plane of the scene as it is at `time_s`, or the one at params.floor_height.
Plane floor_of(const ViewParams& params, const Bodies& bodies, double time_s);

}  // namespace nuno
