#version 430 core
// A stage of the classic Runge-Kutta method, one invocation a vertex (src/solver/explicit/cpu_rk4.cpp).
// Defined by the caller: FIRST, LAST (0, 1: the stage), and what sim/forces.glsl and sim/bodies.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "shared/rk4.h"
#include "sim/bodies.glsl"

layout(local_size_x = GROUP_SIZE) in;

// old_positions and old_velocities are those of the stage.
layout(binding = UNIT_START_POSITIONS) uniform samplerBuffer start_positions;
layout(binding = UNIT_START_VELOCITIES) uniform samplerBuffer start_velocities;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
layout(std430, binding = BLOCK_POSITION_SUMS) buffer PositionSums { vec4 velocity_sums[]; };
layout(std430, binding = BLOCK_VELOCITY_SUMS) buffer VelocitySums { vec4 acceleration_sums[]; };
layout(location = LOCATION_STAGE_STEP) uniform float next_step; // [s] from the start to the next stage
layout(location = LOCATION_STAGE_WEIGHT) uniform float weight;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(start_positions, vertex);
    vec4 velocity = texelFetch(start_velocities, vertex);
    vec3 x = texelFetch(old_positions, vertex).xyz, v = texelFetch(old_velocities, vertex).xyz;
    vec3 a = acceleration_of(vertex, x, v, position.w, velocity.w);
    Motion start = motion(position.xyz, velocity.xyz);
#if FIRST
    Motion before = motion(vec3(0.0), vec3(0.0));
#else
    Motion before = motion(velocity_sums[vertex].xyz, acceleration_sums[vertex].xyz);
#endif
    Motion sum = rk4_add(before, v, a, weight);
#if LAST
    Motion free = rk4_end(start, sum, substep);
    Motion next = select_motion(position.w, push_out_of_bodies(start.position, free).motion, free);
#else
    Motion next = rk4_stage(start, v, a, next_step);
    velocity_sums[vertex] = vec4(sum.position, 0.0);
    acceleration_sums[vertex] = vec4(sum.velocity, 0.0);
#endif
    new_positions[vertex] = vec4(next.position, position.w);
    new_velocities[vertex] = vec4(next.velocity, velocity.w);
}
