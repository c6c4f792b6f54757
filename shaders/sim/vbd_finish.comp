#version 430 core
// The end of a substep of vertex block descent: velocities from the way gone, and contact with bodies. One invocation a
// vertex.
// Defined by the caller: what sim/forces.glsl and sim/bodies.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_MOVES) uniform samplerBuffer moves;
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
layout(location = LOCATION_INVERSE_SUBSTEP) uniform float inverse_substep;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec3 x_start = texelFetch(old_positions, vertex).xyz;
    vec4 v_start = texelFetch(old_velocities, vertex);
    vec4 position = new_positions[vertex];
    precise vec3 v = inverse_substep * texelFetch(moves, vertex).xyz;
    Motion held = push_out_of_bodies(x_start, motion(position.xyz, v)).motion;
    new_positions[vertex] = vec4(select_positive(position.w, held.position, position.xyz), position.w);
    new_velocities[vertex] = vec4(select_positive(position.w, held.velocity, v_start.xyz), v_start.w);
}
