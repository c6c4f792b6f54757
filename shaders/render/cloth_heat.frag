#version 430 core
// The colour of a number, of the vertices or of the face, a little darker where less light falls.
#include "shared/render_bindings.h"
#include "shared/dialect.glsl"
#include "shared/viridis.h"

in float vertex_value;
in float front_light;
in float back_light;
layout(location = LOCATION_HEAT_OF_FACES) uniform bool is_of_faces;
layout(binding = UNIT_HEAT) uniform samplerBuffer heat;
out vec4 colour;

void main()
{
    float value = is_of_faces ? texelFetch(heat, gl_PrimitiveID).r : vertex_value;
    float light = clamp(gl_FrontFacing ? front_light : back_light, 0.0, 1.0);
    colour = vec4(mix(0.7, 1.0, light) * viridis(value), 1.0);
}
