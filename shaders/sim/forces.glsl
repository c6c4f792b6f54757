// What kernels that gather forces share: the inputs of a substep and the acceleration of a vertex.
// Defined by the caller: SPRING_QUADS (slots of the spring entries / 4), DAMPED_SPRINGS (0, 1), CORNER_QUADS (slots of
// the corner table / 4; 0 where no face has a force). IN_ONE_GROUP, where defined, is explained at its place. Include
// after shared/dialect.glsl.
#include "shared/bindings.h"
#include "shared/vector.h"
#include "shared/forces.h"

layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(binding = UNIT_VELOCITIES) uniform samplerBuffer old_velocities; // w: area
layout(binding = UNIT_NEIGHBOURS) uniform isamplerBuffer neighbours;
layout(binding = UNIT_STIFFNESS) uniform samplerBuffer spring_stiffness;
layout(binding = UNIT_TENSION) uniform samplerBuffer spring_tension;
layout(binding = UNIT_AXIAL) uniform samplerBuffer spring_axial;
layout(binding = UNIT_CORNERS) uniform isamplerBuffer corners;
layout(binding = UNIT_FACE_FORCES) uniform samplerBuffer face_forces;
layout(std140, binding = BLOCK_PARAMS) uniform SimParams
{
#include "generated/sim_params"
};
layout(location = LOCATION_SUBSTEP) uniform float substep; // [s]
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;
#ifdef IN_ONE_GROUP
// Substeps run in a loop: what others show of their state, from a place on that changes, and the wind of the substep.
layout(rgba32f, binding = IMAGE_SHOWN_POSITIONS) coherent readonly uniform imageBuffer shown_positions;
layout(rgba32f, binding = IMAGE_SHOWN_VELOCITIES) coherent readonly uniform imageBuffer shown_velocities;
int first_shown;
float wind; // [N/m2]
vec3 position_of(int vertex)
{
    return imageLoad(shown_positions, first_shown + vertex).xyz;
}
vec3 velocity_of(int vertex)
{
    return imageLoad(shown_velocities, first_shown + vertex).xyz;
}
#else
layout(location = LOCATION_WIND) uniform float wind; // [N/m2]
vec3 position_of(int vertex)
{
    return texelFetch(old_positions, vertex).xyz;
}
vec3 velocity_of(int vertex)
{
    return texelFetch(old_velocities, vertex).xyz;
}
#endif

// The springs of one vertex at x with velocity v; four slots a texel, (quad, vertex) at quad * vertex_count + vertex.
vec3 spring_forces(int vertex, vec3 x, vec3 v)
{
    vec3 sum = vec3(0.0);
    for (int quad = 0; quad < SPRING_QUADS; ++quad) {
        int texel = quad * vertex_count + vertex;
        ivec4 n = texelFetch(neighbours, texel);
        vec4 s = texelFetch(spring_stiffness, texel), t = texelFetch(spring_tension, texel);
#if DAMPED_SPRINGS
        vec4 c = stiffness_damping * texelFetch(spring_axial, texel);
#endif
        for (int k = 0; k < 4; ++k) {
            vec3 d = position_of(n[k]) - x;
            precise vec3 with_spring = sum + spring_force(d, s[k], t[k]);
            sum = with_spring;
#if DAMPED_SPRINGS
            vec3 u = velocity_of(n[k]) - v;
            precise vec3 with_damper = sum + spring_damping_force(d, u, c[k]);
            sum = with_damper;
#endif
        }
    }
    return sum;
}

// What sim/faces.comp left at the corners that meet in a vertex.
vec3 force_of_faces(int vertex)
{
    vec3 sum = vec3(0.0);
    for (int quad = 0; quad < CORNER_QUADS; ++quad) {
        ivec4 c = texelFetch(corners, quad * vertex_count + vertex);
        for (int k = 0; k < 4; ++k) {
            precise vec3 with_corner = sum + texelFetch(face_forces, c[k]).xyz;
            sum = with_corner;
        }
    }
    return sum;
}

// Acceleration [m/s2] of a vertex at x with velocity v, neighbours as in the old state; 0 where it is pinned.
vec3 acceleration_of(int vertex, vec3 x, vec3 v, float inverse_mass, float area)
{
    precise float mass = area * areal_density;
    precise float rho = area * damping;
    precise float wind_force = area * wind;
    precise vec3 inner = spring_forces(vertex, x, v);
#if CORNER_QUADS
    precise vec3 with_faces = inner + force_of_faces(vertex);
    inner = with_faces;
#endif
    return acceleration(inverse_mass, mass, vec3(gravity_x, gravity_y, gravity_z), rho, v, inner, wind_force);
}
