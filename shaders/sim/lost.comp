#version 430 core
// Finds the first vertex whose position or velocity is lost (is_lost in src/model/cloth_state.h).
#include "shared/bindings.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer positions;
layout(binding = UNIT_VELOCITIES) uniform samplerBuffer velocities;
layout(std430, binding = BLOCK_FIRST_LOST) buffer FirstLost { uint first_lost; };
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;

// By the bits, which are ordered as the numbers are, since a compiler may take it for granted that every number is one.
bool is_lost(vec3 a)
{
    uvec3 magnitude = floatBitsToUint(a) & uvec3(0x7fffffffu);
    return any(greaterThanEqual(magnitude, uvec3(floatBitsToUint(1e6))));
}

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    if (is_lost(texelFetch(positions, vertex).xyz) || is_lost(texelFetch(velocities, vertex).xyz))
        atomicMin(first_lost, uint(vertex));
}
