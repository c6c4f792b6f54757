#version 430 core
// Finds the first vertex whose position or velocity is not finite.
#include "shared/bindings.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer positions;
layout(binding = UNIT_VELOCITIES) uniform samplerBuffer velocities;
layout(std430, binding = BLOCK_FIRST_BAD) buffer FirstBad { uint first_bad; };
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;

// By its bits, since a compiler may take it for granted that no number is bad.
bool is_bad(vec3 a)
{
    const uint exponent = 0x7f800000u;
    return any(equal(floatBitsToUint(a) & uvec3(exponent), uvec3(exponent)));
}

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    if (is_bad(texelFetch(positions, vertex).xyz) || is_bad(texelFetch(velocities, vertex).xyz))
        atomicMin(first_bad, uint(vertex));
}
