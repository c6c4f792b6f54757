#version 430 core
// A stroke with smooth edges and round ends.
#include "shared/render_bindings.h"

noperspective in vec2 place;
flat in float stroke_length;
flat in vec2 radii;
flat in vec4 stroke_colour;
layout(location = LOCATION_MARK_STRENGTH) uniform float strength;
out vec4 colour;

void main()
{
    float along = clamp(place.x, 0.0, stroke_length);
    float radius = stroke_length > 0.0 ? mix(radii.x, radii.y, along / stroke_length) : radii.x;
    float covered = clamp(radius + 0.5 - distance(place, vec2(along, 0.0)), 0.0, 1.0);
    // A stroke thinner than a pixel is as faint as it is thin.
    covered *= min(1.0, 2.0 * radius + 0.25);
    if (covered <= 0.0) discard;
    colour = vec4(stroke_colour.rgb, stroke_colour.a * covered * strength);
}
