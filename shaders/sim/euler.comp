#version 430 core
// One substep of explicit or symplectic Euler (EULER is the formula's name), one invocation a vertex.
// Defined by the caller: EULER, and what sim/forces.glsl and sim/bodies.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"

layout(local_size_x = GROUP_SIZE) in;

// Read through buffer textures, written through storage blocks: neighbours are only ever read from the state before the
// substep.
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(old_velocities, vertex);
    vec3 a = acceleration_of(vertex, position.xyz, velocity.xyz, position.w, velocity.w);
    Motion free = EULER(position.xyz, velocity.xyz, a, substep);
    Motion held = push_out_of_bodies(position.xyz, free).motion;
    new_positions[vertex] = vec4(select_positive(position.w, held.position, free.position), position.w);
    new_velocities[vertex] = vec4(select_positive(position.w, held.velocity, free.velocity), velocity.w);
}
