#version 430 core
// A body as the key light sees it on the floor.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/shadow_projection.glsl"
#include "render/placed_body.glsl"

out float height;

void main()
{
    vec3 p = placed_position();
    height = height_over_floor(p);
    gl_Position = on_shadow_square(p);
}
