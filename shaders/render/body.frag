#version 430 core
// A body of the scene, matte with a weak highlight.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/lighting.glsl"
#include "render/srgb.glsl"

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main()
{
    vec3 n = normalize(world_normal);
    colour = to_srgb(light_on(n) * body_colour.rgb + highlight_on(world_position, n));
}
