#version 430 core
// Velocity Verlet, one invocation a vertex: KICKS ends a substep (accelerations are taken and kick the velocities),
// DRIFTS begins the next one (src/solver/explicit/cpu_verlet.cpp).
// Defined by the caller: KICKS, DRIFTS (0, 1), and what sim/forces.glsl and sim/bodies.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "shared/verlet.h"
#include "sim/bodies.glsl"

layout(local_size_x = GROUP_SIZE) in;

// old_velocities are those at which accelerations are taken; own_velocities are v0 or v_half.
layout(binding = UNIT_START_VELOCITIES) uniform samplerBuffer own_velocities;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
layout(std430, binding = BLOCK_PREDICTED) writeonly buffer NewPredicted { vec4 new_predicted[]; };
layout(std430, binding = BLOCK_ACCELERATIONS) buffer Accelerations { vec4 accelerations[]; };
layout(location = LOCATION_KICK) uniform float kick_s; // h/2, or 0 where only accelerations are to be found

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(own_velocities, vertex);
#if KICKS
    vec3 v_now = texelFetch(old_velocities, vertex).xyz;
    vec3 a = acceleration_of(vertex, position.xyz, v_now, position.w, velocity.w);
    vec3 v = verlet_kick(velocity.xyz, a, kick_s);
    accelerations[vertex] = vec4(a, 0.0);
#else
    vec3 a = accelerations[vertex].xyz;
    vec3 v = velocity.xyz;
#endif
#if DRIFTS
    Motion free = verlet_drift(position.xyz, v, a, substep);
    Motion held = push_out_of_bodies(position.xyz, free).motion;
    vec3 v_half = select_positive(position.w, held.velocity, free.velocity);
    precise float half_step = 0.5 * substep;
    new_positions[vertex] = vec4(select_positive(position.w, held.position, free.position), position.w);
    new_velocities[vertex] = vec4(v_half, velocity.w);
    new_predicted[vertex] = vec4(verlet_kick(v_half, a, half_step), velocity.w);
#else
    new_velocities[vertex] = vec4(v, velocity.w);
#endif
}
