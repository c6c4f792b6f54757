#version 430 core
// Gives vertices the past that they would have had without anything that came between: all of them, or those whose
// velocity another is given. One invocation a vertex.
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions;
layout(std430, binding = BLOCK_VELOCITIES) buffer Velocities { vec4 velocities[]; };
layout(std430, binding = BLOCK_GIVEN_VELOCITIES) readonly buffer GivenVelocities { vec4 given_velocities[]; };
layout(std430, binding = BLOCK_LAST_POSITIONS) writeonly buffer LastPositions { vec4 last_positions[]; };
layout(std430, binding = BLOCK_LAST_VELOCITIES) writeonly buffer LastVelocities { vec4 last_velocities[]; };
layout(location = LOCATION_SUBSTEP) uniform float substep;
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;
layout(location = LOCATION_ALL) uniform int all_vertices;
layout(location = LOCATION_GRAVITY) uniform vec3 gravity;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 velocity = velocities[vertex];
    if (all_vertices == 0) {
        vec4 given = given_velocities[vertex];
        if (given.xyz == velocity.xyz) return;
        velocity.xyz = given.xyz;
        velocities[vertex] = velocity;
    }
    Motion last = assumed_last(motion(texelFetch(old_positions, vertex).xyz, velocity.xyz), gravity, substep);
    last_positions[vertex] = vec4(last.position, 0.0);
    last_velocities[vertex] = vec4(last.velocity, 0.0);
}
