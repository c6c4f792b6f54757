#version 430 core
// Cloth that is coloured by numbers: the number of a vertex, and the light there.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/above_floor.glsl"
#include "render/lighting.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;
layout(location = ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = LOCATION_HEAT_OF_FACES) uniform bool is_of_faces;
layout(binding = UNIT_HEAT) uniform samplerBuffer heat;

out float vertex_value;
out float front_light;
out float back_light;

void main()
{
    vertex_value = is_of_faces ? 0.0 : texelFetch(heat, gl_VertexID).r;
    front_light = dot(light_on_cloth(normal), vec3(1.0 / 3.0));
    back_light = dot(light_on_cloth(-normal), vec3(1.0 / 3.0));
    cut_at_floor(position);
    gl_Position = view_projection * vec4(position, 1.0);
}
