#version 430 core
// A sphere of the scene: the unit sphere, placed.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 unit_position;
layout(location = ATTRIBUTE_SPHERE) in vec4 sphere;  // centre, radius [m]

out vec3 world_position;
out vec3 world_normal;

void main()
{
    world_position = sphere.xyz + sphere.w * unit_position;
    world_normal = unit_position;
    gl_Position = view_projection * vec4(world_position, 1.0);
}
