#version 430 core
// One substep of explicit or symplectic Euler (EULER is the formula's name), one invocation a vertex.
// Defined by the caller: EULER, STRUCTURAL_QUADS, SHEAR_QUADS, BEND_QUADS (slots of each kind / 4), PLANE_COUNT,
// SPHERE_COUNT.
#include "shared/dialect.glsl"
#include "shared/bindings.h"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/forces.h"
#include "shared/push_out.h"

layout(local_size_x = GROUP_SIZE) in;

// Read through buffer textures, written through storage blocks: neighbours are only ever read from the state before the
// substep.
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions;
layout(binding = UNIT_VELOCITIES) uniform samplerBuffer old_velocities;
layout(binding = UNIT_NEIGHBOURS) uniform isamplerBuffer neighbours;
layout(binding = UNIT_REST_LENGTHS) uniform samplerBuffer rest_lengths;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
layout(std140, binding = BLOCK_PARAMS) uniform SimParams
{
#include "generated/sim_params"
};
layout(std140, binding = BLOCK_COLLIDERS) uniform Colliders
{
    vec4 planes[PLANE_COUNT + 1];   // normal, offset; one more than there are, since none is no array
    vec4 spheres[SPHERE_COUNT + 1]; // centre, radius
};
layout(location = LOCATION_SUBSTEP) uniform float substep; // [s]
layout(location = LOCATION_WIND) uniform float wind;       // [N/m2]
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;

vec3 spring(vec3 sum, vec3 x, int neighbour, float rest_length, float stiffness)
{
    float present = select_positive(rest_length - NO_SPRING, stiffness, 0.0);
    precise vec3 more = sum + spring_force(texelFetch(old_positions, neighbour).xyz - x, rest_length, present);
    return more;
}

vec3 springs_of_quads(vec3 sum, vec3 x, int vertex, int first, int count, float stiffness)
{
    for (int quad = first; quad < first + count; ++quad) {
        ivec4 n = texelFetch(neighbours, quad * vertex_count + vertex);
        vec4 l = texelFetch(rest_lengths, quad * vertex_count + vertex);
        sum = spring(sum, x, n.x, l.x, stiffness);
        sum = spring(sum, x, n.y, l.y, stiffness);
        sum = spring(sum, x, n.z, l.z, stiffness);
        sum = spring(sum, x, n.w, l.w, stiffness);
    }
    return sum;
}

Motion push_out_of_all(Motion m)
{
    for (int i = 0; i < PLANE_COUNT; ++i)
        m = push_out_of_plane(m, planes[i].xyz, planes[i].w, thickness, friction);
    for (int i = 0; i < SPHERE_COUNT; ++i)
        m = push_out_of_sphere(m, spheres[i].xyz, spheres[i].w, thickness, friction);
    return m;
}

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex); // w: inverse mass
    vec4 velocity = texelFetch(old_velocities, vertex); // w: area
    vec3 x = position.xyz;

    vec3 springs = springs_of_quads(vec3(0.0), x, vertex, 0, STRUCTURAL_QUADS, structural_stiffness);
    springs = springs_of_quads(springs, x, vertex, STRUCTURAL_QUADS, SHEAR_QUADS, shear_stiffness);
    springs = springs_of_quads(springs, x, vertex, STRUCTURAL_QUADS + SHEAR_QUADS, BEND_QUADS, bend_stiffness);

    precise float mass = velocity.w * areal_density;
    precise float rho = velocity.w * damping;
    precise float wind_force = velocity.w * wind;
    vec3 a = acceleration(position.w, mass, vec3(gravity_x, gravity_y, gravity_z), rho, velocity.xyz, springs, wind_force);
    Motion free = EULER(x, velocity.xyz, a, substep);
    Motion held = push_out_of_all(free);
    new_positions[vertex] = vec4(select_positive(position.w, held.position, free.position), position.w);
    new_velocities[vertex] = vec4(select_positive(position.w, held.velocity, free.velocity), velocity.w);
}
