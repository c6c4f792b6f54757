#version 430 core
// A sphere as the key light sees it on the floor.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/shadow_projection.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 unit_position;
layout(location = ATTRIBUTE_SPHERE) in vec4 sphere;  // centre, radius [m]

void main()
{
    gl_Position = on_shadow_square(sphere.xyz + sphere.w * unit_position);
}
