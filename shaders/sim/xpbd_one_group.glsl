// Sweeps of xpbd over all springs by one work group, in the order in which sim/xpbd_springs.comp takes them with many
// dispatches. Whoever moved a vertex, others read it after a barrier, as an image: llvmpipe gathers from images, but
// not from blocks.
// Defined by the caller: SMALL_GROUP (invocations), LIMITED, MOST_COLOURS (of sim/xpbd_quads.glsl). Include after
// shared/xpbd.h.
#include "sim/xpbd_quads.glsl"

layout(local_size_x = SMALL_GROUP) in;
layout(binding = UNIT_QUAD_GROUPS) uniform isamplerBuffer groups; // QuadGroup of solver/xpbd/spring_quads.h
layout(std430, binding = BLOCK_STATE) coherent writeonly buffer State { vec4 new_state[]; };
layout(rgba32f, binding = IMAGE_STATE) coherent readonly uniform imageBuffer state; // the same
layout(location = LOCATION_GROUP_COUNT) uniform int group_count;
layout(location = LOCATION_PAIR_COUNT) uniform int pair_count;

void wait_for_all()
{
    memoryBarrier();
    barrier();
}

// Loops over quads and vertices test at the end, since llvmpipe runs a body once in vain after a test at the beginning
// has failed. solver/xpbd/gpu_one_group.cpp counts the turns of all loops.
void project_group(int x, int number, bool forth)
{
    ivec4 group = texelFetch(groups, number); // colours, first quad, quads, first sides
    int quad = int(gl_LocalInvocationID.x);
    if (quad >= group.z) return;
    do {
        ivec4 at = texelFetch(quads, group.y + quad);
        vec4 x0 = imageLoad(state, x + max(at.x, 0)), x1 = imageLoad(state, x + max(at.y, 0));
        vec4 x2 = imageLoad(state, x + max(at.z, 0)), x3 = imageLoad(state, x + max(at.w, 0));
        if (forth)
            project_forth(group.x, group.w + quad, group.z, x0, x1, x2, x3);
        else
            project_back(group.x, group.w + quad, group.z, x0, x1, x2, x3);
        if (at.x >= 0) new_state[x + at.x].xyz = x0.xyz;
        if (at.y >= 0) new_state[x + at.y].xyz = x1.xyz;
        if (at.z >= 0) new_state[x + at.z].xyz = x2.xyz;
        if (at.w >= 0) new_state[x + at.w].xyz = x3.xyz;
        quad += SMALL_GROUP;
    } while (quad < group.z);
}

// `pair_count` times every colour once, and once more in reverse, in the positions that begin at x; others may still be
// about to write these.
void sweep_springs(int x)
{
    for (int pair = 0; pair < pair_count; ++pair) {
        for (int group = 0; group < group_count; ++group) {
            wait_for_all();
            project_group(x, group, true);
        }
        for (int group = group_count - 1; group >= 0; --group) {
            wait_for_all();
            project_group(x, group, false);
        }
    }
}
