// The beginning and the end of a substep of xpbd for one vertex, as src/solver/xpbd/mesh_motion.cpp has them.
// Defined by the caller: what sim/forces.glsl, sim/bodies.glsl and sim/tethers.glsl need; IN_ONE_GROUP as there.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "sim/bodies.glsl"
#include "sim/xpbd_forces.glsl"
#include "shared/xpbd.h"

layout(location = LOCATION_STEP) uniform float step_s;
layout(location = LOCATION_KEEP) uniform float keep;
layout(location = LOCATION_PER_STEP) uniform float per_step;

// Motion without springs, and contact with bodies; `last` is the motion one substep before `start`.
Motion motion_without_springs(int vertex, float inverse_mass, Motion start, Motion last)
{
    Motion m = predicted_motion(start, last, free_acceleration(vertex, inverse_mass), keep, step_s);
    return select_motion(inverse_mass, push_out_of_bodies(start.position, m).motion, start);
}

// At the end of a substep, x where springs moved the vertex to: the velocity that takes in what moved it from
// `predicted`, where v was the velocity, and contact with bodies. `last`, the motion at the start of the substep,
// becomes what the next one takes for it.
Motion motion_with_springs(int vertex, vec4 x, vec3 v, vec3 predicted, inout Motion last)
{
    vec3 end = corrected_velocity(v, predicted, x.xyz, per_step);
    Motion m = motion(x.xyz, end);
    if (body_count > 0) {
        m = push_out_of_bodies(last.position, m).motion;
        last = last_after_contact(last, m, end, free_acceleration(vertex, x.w), substep);
    }
    return select_motion(x.w, m, motion(x.xyz, v));
}
