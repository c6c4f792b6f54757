#version 430 core
// Projects the plates (quadratic bending over an edge) of one colour in place, as sim/xpbd_springs.comp does springs.
// One invocation a plate.
#include "shared/bindings.h"
#include "shared/dialect.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(binding = UNIT_ENDS) uniform isamplerBuffer ends;              // four vertices; -1 where nothing is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer coefficients;
layout(binding = UNIT_SHARES) uniform samplerBuffer shares;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first;
layout(location = LOCATION_END_PLACE) uniform int end;

void main()
{
    int plate = first + int(gl_GlobalInvocationID.x);
    if (plate >= end) return;
    ivec4 at = texelFetch(ends, plate);
    if (at.x < 0) return;
    vec4 number = texelFetch(coefficients, plate);
    vec4 x[4];
    for (int k = 0; k < 4; ++k) x[k] = texelFetch(old_positions, at[k]);
    precise vec3 sum = number[0] * x[0].xyz;
    for (int k = 1; k < 4; ++k) {
        precise vec3 with_corner = sum + number[k] * x[k].xyz;
        sum = with_corner;
    }
    precise vec3 move = texelFetch(shares, plate).x * sum;
    for (int k = 0; k < 4; ++k) {
        precise vec3 moved = x[k].xyz - (x[k].w * number[k]) * move;
        new_positions[at[k]] = vec4(moved, x[k].w);
    }
}
