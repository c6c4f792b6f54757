#version 430 core
// The end of a substep of xpbd: the velocity that takes in what moved the vertex, and contact with bodies; as
// src/solver/xpbd/mesh_motion.cpp has it. One invocation a vertex.
// Defined by the caller: what sim/forces.glsl and sim/bodies.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"
#include "sim/xpbd_forces.glsl"
#include "shared/xpbd.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_PREDICTED) uniform samplerBuffer predicted;
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) buffer NewVelocities { vec4 new_velocities[]; };
// The state at the start of the substep, which the next one will take for the last.
layout(std430, binding = BLOCK_LAST_POSITIONS) buffer LastPositions { vec4 last_positions[]; };
layout(std430, binding = BLOCK_LAST_VELOCITIES) buffer LastVelocities { vec4 last_velocities[]; };
layout(location = LOCATION_PER_STEP) uniform float per_step;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = new_positions[vertex], velocity = new_velocities[vertex];
    vec3 end = corrected_velocity(velocity.xyz, texelFetch(predicted, vertex).xyz, position.xyz, per_step);
    Motion m = motion(position.xyz, end);
    if (body_count > 0) {
        vec4 last_x = last_positions[vertex], last_v = last_velocities[vertex];
        m = push_out_of_bodies(last_x.xyz, m).motion;
        Motion last = last_after_contact(motion(last_x.xyz, last_v.xyz), m, end, free_acceleration(vertex, position.w),
                                         substep);
        last_positions[vertex] = vec4(last.position, last_x.w);
        last_velocities[vertex] = vec4(last.velocity, last_v.w);
        new_positions[vertex] = vec4(select_positive(position.w, m.position, position.xyz), position.w);
    }
    new_velocities[vertex] = vec4(select_positive(position.w, m.velocity, velocity.xyz), velocity.w);
}
