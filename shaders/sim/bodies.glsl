// Contact with the rigid bodies of a scene, as src/solver/base/body_push_out.h has it.
// Defined by the caller: PLANE_COUNT, SPHERE_COUNT, CAPSULE_COUNT, BOX_COUNT, MESH_COUNT. Include after shared/euler.h
// and what declares the block SimParams and the uniform `substep` (sim/forces.glsl).
#include "shared/body_shapes.h"
#include "shared/push_out.h"

layout(binding = UNIT_BODIES) uniform samplerBuffer body_steps;    // BodyStep of src/model/body_steps.h
layout(binding = UNIT_DISTANCES) uniform samplerBuffer distances;  // BodySteps::grid_numbers
#ifdef IN_ONE_GROUP
layout(location = LOCATION_FIRST_BODY) uniform int first_body_of_all; // of the first substep
int first_body;                                                       // of this substep
#else
layout(location = LOCATION_FIRST_BODY) uniform int first_body; // of this substep
#endif

const int spheres_from = PLANE_COUNT;
const int capsules_from = spheres_from + SPHERE_COUNT;
const int boxes_from = capsules_from + CAPSULE_COUNT;
const int meshes_from = boxes_from + BOX_COUNT;
const int body_count = meshes_from + MESH_COUNT;

vec2 two_distances(int first)
{
    return vec2(texelFetch(distances, first).x, texelFetch(distances, first + 1).x);
}

// The mesh whose grid begins at `first`, seen from the point q in its axes.
Surface mesh_surface(int first, vec3 q)
{
    vec3 origin = vec3(texelFetch(distances, first).x, texelFetch(distances, first + 1).x, texelFetch(distances, first + 2).x);
    float cell_size = texelFetch(distances, first + 3).x;
    float per_metre = texelFetch(distances, first + 4).x;
    vec3 cells = vec3(texelFetch(distances, first + 5).x, texelFetch(distances, first + 6).x, texelFetch(distances, first + 7).x);
    GridPlace place = grid_place(q, origin, cell_size, per_metre, cells);
    if (!(place.beyond < thickness + CONTACT_SKIN)) return surface(q, 1e30);
    int row = int(cells.x) + 1, layer = row * (int(cells.y) + 1);
    int node = first + GRID_HEADER + int(place.cell.z) * layer + int(place.cell.y) * row + int(place.cell.x);
    vec2 a = two_distances(node), b = two_distances(node + row);
    vec2 c = two_distances(node + layer), d = two_distances(node + layer + row);
    CellCorners corners;
    corners.low_low[0] = a.x;
    corners.low_low[1] = a.y;
    corners.high_low[0] = b.x;
    corners.high_low[1] = b.y;
    corners.low_high[0] = c.x;
    corners.low_high[1] = c.y;
    corners.high_high[0] = d.x;
    corners.high_high[1] = d.y;
    return grid_surface(place, corners);
}

// Whether a particle at d from a body's position may be nearer to it than the distance kept. It only saves work.
bool may_touch(int number, float radius, float half_length, vec3 d)
{
    if (number < spheres_from) return true;
    float bound = number < boxes_from ? radius + half_length : radius;
    float reach = (bound + thickness) * 1.001 + 1e-4;
    return dot_product(d, d) < reach * reach;
}

// The surface of a body whose BodyStep begins at `texel`, seen from x; far away where it cannot touch.
Surface surface_of(int number, int texel, vec3 x)
{
    vec4 position = texelFetch(body_steps, texel);
    vec4 y_axis = texelFetch(body_steps, texel + 2);
    precise vec3 d = x - position.xyz;
    if (!may_touch(number, position.w, y_axis.w, d)) return surface(d, 1e30);
    if (number < spheres_from) return plane_surface(d, y_axis.xyz);
    if (number < capsules_from) return sphere_surface(d, position.w, y_axis.xyz);
    vec4 x_axis = texelFetch(body_steps, texel + 1);
    if (number < boxes_from) return capsule_surface(d, x_axis.xyz, y_axis.xyz, y_axis.w, position.w);
    vec4 z_axis = texelFetch(body_steps, texel + 3);
    vec3 q = to_body(d, x_axis.xyz, y_axis.xyz, z_axis.xyz);
    Surface s;
    if (number < meshes_from)
        s = box_surface(q, vec3(x_axis.w, y_axis.w, z_axis.w));
    else
        s = mesh_surface(int(texelFetch(body_steps, texel + 4).w) * GRID_HEADER, q);
    s.normal = to_world(s.normal, x_axis.xyz, y_axis.xyz, z_axis.xyz);
    return s;
}

// Contact of a particle that was at x_start before the substep and has the motion m after it with every body, one after
// another.
Contact push_out_of_bodies(vec3 x_start, Motion m)
{
    Contact held = free_of_contact(m);
    for (int number = 0; number < body_count; ++number) {
        int texel = (first_body + number) * BODY_TEXELS;
        Surface s = surface_of(number, texel, held.motion.position);
        precise float gap = s.distance - thickness;
        if (!(gap < CONTACT_SKIN)) continue;
        s.distance = gap;
        vec4 row_x = texelFetch(body_steps, texel + 5), row_y = texelFetch(body_steps, texel + 6);
        vec4 row_z = texelFetch(body_steps, texel + 7);
        vec3 velocity = velocity_of_body(x_start, texelFetch(body_steps, texel + 4).xyz, row_x.xyz, row_y.xyz, row_z.xyz,
                                         vec3(row_x.w, row_y.w, row_z.w));
        Friction coefficients;
        coefficients.kinetic = friction;
        coefficients.resting = max_real(friction, static_friction);
        Contact next = push_out(x_start, held.motion, s, velocity, coefficients, substep);
        held.motion = next.motion;
        held.sticks = max_real(held.sticks, next.sticks);
    }
    return held;
}
