#version 430 core
// Woven cloth: hands on to every pixel what its light needs.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec4 normal_and_fold;
layout(location = ATTRIBUTE_UV) in vec2 uv;
layout(location = LOCATION_TEXTURE_SCALE) uniform float texture_scale;
layout(location = LOCATION_WEAVE_SCALE) uniform vec2 weave_scale;  // repeats of the weave along a sheet, each way

out vec3 world_position;
out vec3 world_normal;
out float fold;
out vec2 texture_uv;
out vec2 weave_uv;

void main()
{
    world_position = position;
    world_normal = normal_and_fold.xyz;
    fold = normal_and_fold.w;
    texture_uv = texture_scale * uv;
    weave_uv = weave_scale * uv;
    cut_at_floor(position);
    gl_Position = view_projection * vec4(position, 1.0);
}
