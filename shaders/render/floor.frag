#version 430 core
// The floor: faint tiles, the shadow, and a fade into the background with the distance from the stage.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/background.glsl"
#include "render/display.glsl"
#ifdef SOFT_SHADOWS
#include "render/fabric_block.glsl"
#include "render/floor_penumbra.glsl"
#else
#include "render/floor_shadow.glsl"
#endif

in vec3 world_position;
flat in vec3 key;
flat in vec3 soft;
out vec4 colour;

// 0 and 1 on the tiles in turns, averaged over the pixel.
float tiles(vec2 p)
{
    vec2 width = max(fwidth(p), 1e-5);
    vec2 wave = 2.0 * (abs(fract(0.5 * (p - 0.5 * width)) - 0.5) - abs(fract(0.5 * (p + 0.5 * width)) - 0.5)) / width;
    return 0.5 - 0.5 * wave.x * wave.y;
}

// How much of the key light cloth and bodies take away.
float shadow_at(vec2 on_floor)
{
    return shadow_centre.w > 0.0 ? floor_shadow_at(on_floor / shadow_centre.w) : 0.0;
}

void main()
{
    vec3 from_shadow = world_position - shadow_centre.xyz;
    float shadow = shadow_at(vec2(dot(from_shadow, floor_across.xyz), dot(from_shadow, floor_along.xyz)));
    vec3 light = (1.0 - 0.9 * shadow) * key + (1.0 - 0.25 * shadow) * soft;
    const float tile_side = 0.25;  // [m]
    vec2 tile = vec2(dot(world_position, floor_across.xyz), dot(world_position, floor_along.xyz)) / tile_side;
    vec3 surface = light * mix(tile_dark.rgb, tile_light.rgb, tiles(tile));
    float distance_sq = dot(world_position - floor_centre.xyz, world_position - floor_centre.xyz);
    float near = exp(-distance_sq / (floor_centre.w * floor_centre.w));
    colour = to_display(mix(background(normalize(world_position - eye.xyz)), surface, near));
}
