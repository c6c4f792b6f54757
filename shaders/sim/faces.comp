#version 430 core
// Forces on the corners of each face, one invocation a face; vertices gather them in sim/forces.glsl.
// Defined by the caller: MEMBRANE, AIR, GUSTS (0, 1).
#include "shared/dialect.glsl"
#include "shared/bindings.h"
#include "shared/vector.h"
#include "shared/membrane.h"
#include "shared/gust.h"
#include "shared/aero.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions;
layout(binding = UNIT_VELOCITIES) uniform samplerBuffer old_velocities;
layout(binding = UNIT_FACES) uniform isamplerBuffer faces;
// Two texels: warp_1, warp_2, weft_1, weft_2; area, mass_area.
layout(binding = UNIT_FACE_RESTS) uniform samplerBuffer face_rests;
layout(std430, binding = BLOCK_FACE_FORCES) writeonly buffer FaceForces { vec4 face_forces[]; };
layout(std140, binding = BLOCK_PARAMS) uniform SimParams
{
#include "generated/sim_params"
};
layout(location = LOCATION_SUBSTEP) uniform float substep; // [s]
layout(location = LOCATION_FACE_COUNT) uniform int face_count;
layout(location = LOCATION_GUST) uniform vec4 gust; // offset, cells a metre
layout(location = LOCATION_GUST_SEED) uniform uint gust_bits;

vec3 air_velocity(vec3 centre)
{
    vec3 wind = vec3(wind_x, wind_y, wind_z);
#if GUSTS
    wind = gusty_air(wind, gust_speed, gust_place(centre, gust.xyz, gust.w), gust_bits);
#endif
    return wind;
}

MembraneConstants membrane_constants()
{
    MembraneConstants c;
    c.warp = warp_stiffness;
    c.weft = weft_stiffness;
    c.cross = cross_stiffness;
    c.shear = shear_modulus;
    c.damping = stiffness_damping;
    return c;
}

Air air_of()
{
    Air air;
    air.density = air_density;
    air.pressure = pressure_coefficient;
    air.skin = skin_coefficient;
    air.areal_density = areal_density;
    air.h = substep;
    return air;
}

FaceRest face_rest(int face)
{
    vec4 gradients = texelFetch(face_rests, 2 * face);
    FaceRest rest;
    rest.warp_1 = gradients.x;
    rest.warp_2 = gradients.y;
    rest.weft_1 = gradients.z;
    rest.weft_2 = gradients.w;
    vec2 areas = texelFetch(face_rests, 2 * face + 1).xy;
    rest.area = areas.x;
    rest.mass_area = areas.y;
    return rest;
}

void main()
{
    int face = int(gl_GlobalInvocationID.x);
    if (face >= face_count) return;
    ivec3 corners = texelFetch(faces, face).xyz;
    vec3 x0 = texelFetch(old_positions, corners.x).xyz, v0 = texelFetch(old_velocities, corners.x).xyz;
    vec3 x1 = texelFetch(old_positions, corners.y).xyz, v1 = texelFetch(old_velocities, corners.y).xyz;
    vec3 x2 = texelFetch(old_positions, corners.z).xyz, v2 = texelFetch(old_velocities, corners.z).xyz;
    FaceRest rest = face_rest(face);
    CornerForces inner;
    inner.on_1 = vec3(0.0);
    inner.on_2 = vec3(0.0);
    vec3 outer = vec3(0.0);
#if MEMBRANE
    inner = membrane_forces(x1 - x0, x2 - x0, v1 - v0, v2 - v0, rest, membrane_constants());
#endif
#if AIR
    vec3 u = relative_air(air_velocity(face_mean(x0, x1, x2)), face_mean(v0, v1, v2));
    outer = third_of(face_air_force(x1 - x0, x2 - x0, u, rest.mass_area, air_of()));
#endif
    precise vec3 on_0 = outer - (inner.on_1 + inner.on_2);
    precise vec3 on_1 = outer + inner.on_1;
    precise vec3 on_2 = outer + inner.on_2;
    face_forces[face] = vec4(on_0, 0.0);
    face_forces[face_count + face] = vec4(on_1, 0.0);
    face_forces[2 * face_count + face] = vec4(on_2, 0.0);
}
