#version 430 core
// A stroke between two places as a quad that faces the eye, a pixel wider than the stroke on every side.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"

layout(location = ATTRIBUTE_MARK_FROM) in vec4 from;  // w: width there [pixels of the reference picture]
layout(location = ATTRIBUTE_MARK_TO) in vec4 to;
layout(location = ATTRIBUTE_MARK_COLOUR) in vec4 mark_colour;
layout(location = LOCATION_PICTURE_SIZE) uniform vec2 picture_size;
layout(location = LOCATION_MARK_SCALE) uniform float mark_scale;

noperspective out vec2 place;  // [pixels] from `from`: along the stroke, and across
flat out float stroke_length;  // [pixels]
flat out vec2 radii;           // [pixels] at `from` and `to`
flat out vec4 stroke_colour;

// Nearer to the eye by a part of the way, which leaves its place in the picture as it is: so that what lies in the
// cloth is not half hidden by it.
vec4 lifted(vec3 p)
{
    return view_projection * vec4(mix(p, eye.xyz, 0.0015), 1.0);
}

void main()
{
    vec4 a = lifted(from.xyz), b = lifted(to.xyz);
    // Only what lies beyond the near plane has a place in the picture.
    float a_beyond = a.z + a.w, b_beyond = b.z + b.w;
    if (a_beyond < 0.0 && b_beyond > 0.0) a = mix(a, b, a_beyond / (a_beyond - b_beyond));
    if (b_beyond < 0.0 && a_beyond > 0.0) b = mix(b, a, b_beyond / (b_beyond - a_beyond));
    vec2 a_pixel = 0.5 * picture_size * a.xy / a.w, b_pixel = 0.5 * picture_size * b.xy / b.w;
    stroke_length = distance(a_pixel, b_pixel);
    vec2 along = stroke_length > 1e-3 ? (b_pixel - a_pixel) / stroke_length : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    radii = 0.5 * mark_scale * vec2(from.w, to.w);
    stroke_colour = mark_colour;

    bool at_end = gl_VertexID >= 2;
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    float room = max(radii.x, radii.y) + 1.0;
    place = vec2(at_end ? stroke_length + room : -room, side * room);
    vec2 pixel = a_pixel + place.x * along + place.y * across;
    vec4 end = at_end ? b : a;
    cut_at_floor(at_end ? to.xyz : from.xyz);
    gl_Position = vec4(2.0 * pixel / picture_size * end.w, end.z, end.w);
    if (a_beyond < 0.0 && b_beyond < 0.0) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}
