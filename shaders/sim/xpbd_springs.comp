#version 430 core
// Projects the springs of one colour in place: no two of them share a vertex, so none reads what this dispatch writes
// for another. One invocation a spring.
// Defined by the caller: LIMITED (0, 1).
#include "sim/xpbd_springs.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first;
layout(location = LOCATION_END_PLACE) uniform int end;

void main()
{
    int spring = first + int(gl_GlobalInvocationID.x);
    if (spring >= end) return;
    ivec2 at = texelFetch(ends, spring).xy;
    if (at.x < 0) return;
    vec4 a = texelFetch(old_positions, at.x), b = texelFetch(old_positions, at.y);
    project(spring, a, b);
    new_positions[at.x] = a;
    new_positions[at.y] = b;
}
