#version 430 core
// The beginning of a substep of xpbd: motion without springs, contact with bodies, tethers. One invocation a vertex.
// Defined by the caller: what sim/xpbd_motion.glsl and sim/tethers.glsl need.
#include "sim/xpbd_motion.glsl"
#include "sim/tethers.glsl"

layout(local_size_x = GROUP_SIZE) in;
// What these two hold before is the state one substep ago.
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) buffer NewVelocities { vec4 new_velocities[]; };
layout(std430, binding = BLOCK_XPBD_PREDICTED) writeonly buffer Predicted { vec4 predicted[]; };

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(old_velocities, vertex);
    Motion start = motion(position.xyz, velocity.xyz);
    Motion last = motion(new_positions[vertex].xyz, new_velocities[vertex].xyz);
    Motion m = motion_without_springs(vertex, position.w, start, last);
    new_velocities[vertex] = vec4(m.velocity, velocity.w);
    predicted[vertex] = vec4(m.position, position.w);
    vec3 held = within_tethers(vertex, m.position);
    new_positions[vertex] = vec4(select_positive(position.w, held, position.xyz), position.w);
}
