#version 430 core
// Substeps of explicit or symplectic Euler of a small cloth, one after another in one work group: what sim/euler.comp
// does with a dispatch a substep. One invocation a vertex; its own state stays with it, and what neighbours read of it
// goes through memory that they read as an image, one side of it written while the other is read.
// Defined by the caller: EULER, SMALL_GROUP (invocations, one a vertex at least), and what sim/forces.glsl and
// sim/bodies.glsl need.
#define IN_ONE_GROUP
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"

layout(local_size_x = SMALL_GROUP) in;
layout(binding = UNIT_WINDS) uniform samplerBuffer winds; // [N/m2], one a substep
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
// What shown_positions and shown_velocities of sim/forces.glsl read.
layout(std430, binding = BLOCK_SHOWN_POSITIONS) coherent writeonly buffer ShownX { vec4 showing_positions[]; };
layout(std430, binding = BLOCK_SHOWN_VELOCITIES) coherent writeonly buffer ShownV { vec4 showing_velocities[]; };
layout(location = LOCATION_SUBSTEP_COUNT) uniform int substep_count;
layout(location = LOCATION_BODIES_A_SUBSTEP) uniform int bodies_a_substep;

void show(int place, vec4 position, vec4 velocity)
{
    showing_positions[place] = position;
#if DAMPED_SPRINGS
    showing_velocities[place] = velocity;
#endif
}

void main()
{
    int vertex = min(int(gl_LocalInvocationID.x), vertex_count - 1);
    bool own = int(gl_LocalInvocationID.x) < vertex_count;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(old_velocities, vertex);
    if (own) show(vertex, position, velocity);
    for (int k = 0; k < substep_count; ++k) {
        memoryBarrier();
        barrier();
        int odd = k & 1;
        first_shown = odd * vertex_count;
        first_body = first_body_of_all + k * bodies_a_substep;
        wind = texelFetch(winds, k).x;
        vec3 a = acceleration_of(vertex, position.xyz, velocity.xyz, position.w, velocity.w);
        Motion free = EULER(position.xyz, velocity.xyz, a, substep);
        Motion held = push_out_of_bodies(position.xyz, free).motion;
        position.xyz = select_positive(position.w, held.position, free.position);
        velocity.xyz = select_positive(position.w, held.velocity, free.velocity);
        if (own) show((1 - odd) * vertex_count + vertex, position, velocity);
    }
    if (own) {
        new_positions[vertex] = position;
        new_velocities[vertex] = velocity;
    }
}
