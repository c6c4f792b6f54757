#version 430 core
// All sweeps of a substep over the springs of a small cloth in one work group, its positions in shared memory: what
// sim/xpbd_springs.comp does with a dispatch a colour, in the same order.
// Defined by the caller: LIMITED (0, 1), SMALL_GROUP (invocations), SMALL_VERTICES (room).
#include "sim/xpbd_springs.glsl"

layout(local_size_x = SMALL_GROUP) in;
layout(binding = UNIT_ENDS) uniform isamplerBuffer ends;      // two vertices; -1 where nothing is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer numbers; // SpringNumber of solver/xpbd/constraint_colours.h
layout(binding = UNIT_COLOUR_STARTS) uniform isamplerBuffer colour_starts;
layout(std430, binding = BLOCK_POSITIONS) buffer Positions { vec4 positions[]; }; // w: inverse mass
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;
layout(location = LOCATION_COLOUR_COUNT) uniform int colour_count;
layout(location = LOCATION_PAIR_COUNT) uniform int pair_count;

shared vec4 x[SMALL_VERTICES];

void main()
{
    int own = int(gl_LocalInvocationID.x);
    for (int vertex = own; vertex < vertex_count; vertex += SMALL_GROUP) x[vertex] = positions[vertex];
    int turns = 2 * colour_count * pair_count;
    for (int turn = 0; turn < turns; ++turn) {
        memoryBarrierShared();
        barrier();
        int step = turn % (2 * colour_count);
        int colour = step < colour_count ? step : 2 * colour_count - 1 - step;
        int end = texelFetch(colour_starts, colour + 1).x;
        for (int spring = texelFetch(colour_starts, colour).x + own; spring < end; spring += SMALL_GROUP) {
            ivec2 at = texelFetch(ends, spring).xy;
            if (at.x >= 0) project(texelFetch(numbers, spring), x[at.x], x[at.y]);
        }
    }
    memoryBarrierShared();
    barrier();
    for (int vertex = own; vertex < vertex_count; vertex += SMALL_GROUP) positions[vertex] = x[vertex];
}
