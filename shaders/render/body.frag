#version 430 core
// A body of the scene, matte with a weak highlight.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/lighting.glsl"
#include "render/display.glsl"
#ifdef SOFT_SHADOWS
#include "render/fabric_block.glsl"
#include "render/key_shadow.glsl"
#endif

in vec3 world_position;
in vec3 world_normal;
out vec4 colour;

void main()
{
    vec3 n = normalize(world_normal);
#ifdef SOFT_SHADOWS
    float lit = key_light_at(world_position, n);
#else
    const float lit = 1.0;
#endif
    colour = to_display((lit * key_on(n) + soft_on(n)) * body_colour.rgb + lit * highlight_on(world_position, n));
}
