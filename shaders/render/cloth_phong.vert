#version 430 core
// Phong shading: hands position and normal on to every pixel.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = LOCATION_TEXTURE_SCALE) uniform float texture_scale;

out vec3 world_position;
out vec3 world_normal;
out vec2 texture_uv;

void main()
{
    world_position = position;
    world_normal = normal;
    texture_uv = texture_scale * uv;
    cut_at_floor(position);
    gl_Position = view_projection * vec4(position, 1.0);
}
