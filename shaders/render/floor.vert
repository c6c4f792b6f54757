#version 430 core
// The floor: one square that reaches to where it has faded.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/lighting.glsl"

out vec3 world_position;
flat out vec3 key;   // light on all of the floor
flat out vec3 soft;

void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    world_position =
        floor_centre.xyz + floor_across.w * (corner.x * floor_across.xyz + corner.y * floor_along.xyz);
    key = key_on(floor_plane.xyz);
    soft = soft_on(floor_plane.xyz);
    gl_Position = view_projection * vec4(world_position, 1.0);
}
