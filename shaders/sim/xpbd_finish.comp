#version 430 core
// The end of a substep of xpbd: the velocity that takes in what moved the vertex, and contact with bodies. One
// invocation a vertex.
// Defined by the caller: what sim/xpbd_motion.glsl needs.
#include "sim/xpbd_motion.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_PREDICTED) uniform samplerBuffer predicted;
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) buffer NewVelocities { vec4 new_velocities[]; };
// The state at the start of the substep, which the next one will take for the last.
layout(std430, binding = BLOCK_LAST_POSITIONS) buffer LastPositions { vec4 last_positions[]; };
layout(std430, binding = BLOCK_LAST_VELOCITIES) buffer LastVelocities { vec4 last_velocities[]; };

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = new_positions[vertex], velocity = new_velocities[vertex];
    vec4 last_x = last_positions[vertex], last_v = last_velocities[vertex];
    Motion last = motion(last_x.xyz, last_v.xyz);
    Motion m = motion_with_springs(vertex, position, velocity.xyz, texelFetch(predicted, vertex).xyz, last);
    new_velocities[vertex] = vec4(m.velocity, velocity.w);
    if (body_count > 0) {
        new_positions[vertex] = vec4(m.position, position.w);
        last_positions[vertex] = vec4(last.position, last_x.w);
        last_velocities[vertex] = vec4(last.velocity, last_v.w);
    }
}
