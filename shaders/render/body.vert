#version 430 core
// A body of the scene, in place.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"
#include "render/placed_body.glsl"

out vec3 world_position;
out vec3 world_normal;

void main()
{
    world_position = placed_position();
    world_normal = to_world(normal);
    cut_at_floor(world_position);
    gl_Position = view_projection * vec4(world_position, 1.0);
}
