#version 430 core
// Gouraud shading: the light on both sides of the cloth, at each vertex.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"
#include "render/lighting.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = LOCATION_TEXTURE_SCALE) uniform float texture_scale;

out vec3 front_light;
out vec3 back_light;
out vec2 texture_uv;

void main()
{
    front_light = light_on_cloth(normal);
    back_light = light_on_cloth(-normal);
    texture_uv = texture_scale * uv;
    cut_at_floor(position);
    gl_Position = view_projection * vec4(position, 1.0);
}
