// A camera that orbits its target.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/view_params.h"

namespace nuno {

struct Camera
{
    glm::vec3 eye;                 // [m]
    glm::vec3 right, up, forward;  // of unit length
    float tan_half_height;         // of half the angle between the top and the bottom of the picture
    float aspect;                  // width / height
    glm::mat4 view_projection;     // no far plane
};

// `aspect`: width / height of the picture.
Camera make_camera(const ViewParams& params, float aspect);

struct Ray
{
    glm::vec3 origin;     // [m]
    glm::vec3 direction;  // of unit length
};

// Through the point `pixel` of a picture of `size` pixels, counted from its top left corner; the centre is size / 2.
Ray ray_through(const Camera& camera, glm::vec2 pixel, glm::vec2 size);

// The mouse was dragged by `pixels` (x right, y down): turns the camera around its target, half a turn over `height`
// pixels.
void orbit(ViewParams& params, glm::vec2 pixels, float height);

// Moves camera and target with the picture, so that the point under the mouse stays there at the target's distance.
void pan(ViewParams& params, glm::vec2 pixels, float height);

// The wheel was turned by `notches`; each brings the camera a tenth nearer.
void zoom(ViewParams& params, float notches);

// Moves target and distance so that the box low .. high [m] fills the picture, from the direction the camera has.
void frame_box(ViewParams& params, glm::vec3 low, glm::vec3 high, float aspect);

}  // namespace nuno
