#version 430 core
// The beginning of a substep of xpbd: motion without springs, contact with bodies, tethers; as
// src/solver/xpbd/mesh_motion.cpp has it. One invocation a vertex.
// Defined by the caller: what sim/forces.glsl, sim/bodies.glsl and sim/tethers.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"
#include "sim/xpbd_forces.glsl"
#include "shared/xpbd.h"
#include "sim/tethers.glsl"

layout(local_size_x = GROUP_SIZE) in;
// What these two hold before is the state one substep ago.
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) buffer NewVelocities { vec4 new_velocities[]; };
layout(std430, binding = BLOCK_XPBD_PREDICTED) writeonly buffer Predicted { vec4 predicted[]; };
layout(location = LOCATION_STEP) uniform float step_s;
layout(location = LOCATION_KEEP) uniform float keep;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(old_velocities, vertex);
    vec3 x = position.xyz;
    Motion start = motion(x, velocity.xyz);
    Motion last = motion(new_positions[vertex].xyz, new_velocities[vertex].xyz);
    Motion m = predicted_motion(start, last, free_acceleration(vertex, position.w), keep, step_s);
    m = select_motion(position.w, push_out_of_bodies(x, m).motion, start);
    new_velocities[vertex] = vec4(m.velocity, velocity.w);
    predicted[vertex] = vec4(m.position, position.w);
    new_positions[vertex] = vec4(select_positive(position.w, within_tethers(vertex, m.position), x), position.w);
}
