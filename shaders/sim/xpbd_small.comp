#version 430 core
// Substeps of xpbd of a small cloth, one after another in one work group: what sim/xpbd_predict.comp,
// sim/xpbd_springs.comp and sim/xpbd_finish.comp do with many dispatches a substep, in the same order.
// Defined by the caller: what sim/xpbd_motion.glsl, sim/tethers.glsl and sim/xpbd_one_group.glsl need.
// The state is five rows of a vec4 for each vertex: the positions of both sides, of which a substep reads one and
// writes the other, the velocities of both, and what is predicted. Only positions are read by other invocations than
// the one that has the vertex.
#define IN_ONE_GROUP
#include "sim/xpbd_motion.glsl"
#include "sim/tethers.glsl"
#include "sim/xpbd_one_group.glsl"

layout(binding = UNIT_COMMON) uniform samplerBuffer commons; // common_acceleration, one a substep
layout(location = LOCATION_SUBSTEP_COUNT) uniform int substep_count;
layout(location = LOCATION_BODIES_A_SUBSTEP) uniform int bodies_a_substep;
layout(location = LOCATION_FIRST_SIDE) uniform int first_side; // that the first substep reads

int old_x, new_x, old_v, new_v, predicted; // where each row begins

void begin_substep()
{
    int vertex = int(gl_LocalInvocationID.x);
    if (vertex >= vertex_count) return;
    do {
        vec4 position = imageLoad(state, old_x + vertex), velocity = imageLoad(state, old_v + vertex);
        Motion start = motion(position.xyz, velocity.xyz);
        Motion last = motion(imageLoad(state, new_x + vertex).xyz, imageLoad(state, new_v + vertex).xyz);
        Motion m = motion_without_springs(vertex, position.w, start, last);
        vec3 held = within_tethers(vertex, m.position);
        new_state[new_v + vertex] = vec4(m.velocity, velocity.w);
        new_state[predicted + vertex].xyz = m.position;
        new_state[new_x + vertex] = vec4(select_positive(position.w, held, position.xyz), position.w);
        vertex += SMALL_GROUP;
    } while (vertex < vertex_count);
}

void end_substep()
{
    int vertex = int(gl_LocalInvocationID.x);
    if (vertex >= vertex_count) return;
    do {
        vec4 position = imageLoad(state, new_x + vertex), velocity = imageLoad(state, new_v + vertex);
        Motion last = motion(imageLoad(state, old_x + vertex).xyz, imageLoad(state, old_v + vertex).xyz);
        vec3 from = imageLoad(state, predicted + vertex).xyz;
        Motion m = motion_with_springs(vertex, position, velocity.xyz, from, last);
        new_state[new_v + vertex].xyz = m.velocity;
        if (body_count > 0) {
            new_state[new_x + vertex].xyz = m.position;
            new_state[old_x + vertex].xyz = last.position;
            new_state[old_v + vertex].xyz = last.velocity;
        }
        vertex += SMALL_GROUP;
    } while (vertex < vertex_count);
}

void main()
{
    for (int k = 0; k < substep_count; ++k) {
        int side = (first_side + k) & 1;
        old_x = side * vertex_count;
        new_x = (1 - side) * vertex_count;
        old_v = old_x + 2 * vertex_count;
        new_v = new_x + 2 * vertex_count;
        predicted = 4 * vertex_count;
        first_body = first_body_of_all + k * bodies_a_substep;
        common_acceleration = texelFetch(commons, k).xyz;
        begin_substep();
        sweep_springs(new_x);
        wait_for_all();
        end_substep();
        memoryBarrier();
    }
}
