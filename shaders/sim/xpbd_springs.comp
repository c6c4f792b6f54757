#version 430 core
// Projects the springs of one colour in place: no two of them share a vertex, so none reads what this dispatch writes
// for another. One invocation a spring.
// Defined by the caller: LIMITED (0, 1).
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(binding = UNIT_ENDS) uniform isamplerBuffer ends;              // two vertices; -1 where nothing is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer numbers;         // SpringNumber of solver/xpbd/constraint_colours.h
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first;
layout(location = LOCATION_END_PLACE) uniform int end;

void main()
{
    int spring = first + int(gl_GlobalInvocationID.x);
    if (spring >= end) return;
    ivec2 at = texelFetch(ends, spring).xy;
    if (at.x < 0) return;
    vec4 number = texelFetch(numbers, spring);
    vec4 a = texelFetch(old_positions, at.x), b = texelFetch(old_positions, at.y);
    precise vec3 d = b.xyz - a.xyz;
#if LIMITED
    precise float excess = limited_excess(d, number.x, number.z, number.w);
#else
    precise float excess = spring_excess(d, number.x);
#endif
    precise float move = number.y * excess;
    precise vec3 new_a = a.xyz + (a.w * move) * d;
    precise vec3 new_b = b.xyz - (b.w * move) * d;
    new_positions[at.x] = vec4(new_a, a.w);
    new_positions[at.y] = vec4(new_b, b.w);
}
