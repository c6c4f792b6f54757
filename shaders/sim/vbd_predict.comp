#version 430 core
// Where each vertex would go in a substep without springs: the target of vertex block descent, and where it starts. One
// invocation a vertex.
// Defined by the caller: what sim/forces.glsl and sim/tethers.glsl need.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "shared/xpbd.h"
#include "shared/vbd.h"
#include "sim/tethers.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_MOVES) writeonly buffer Moves { vec4 moves[]; };
layout(std430, binding = BLOCK_TARGETS) writeonly buffer Targets { vec4 targets[]; }; // w: mobility

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec4 velocity = texelFetch(old_velocities, vertex);
    vec3 x = position.xyz;
    float inverse_mass = position.w, area = velocity.w;
    precise float mass = area * areal_density;
    precise float rho = area * damping;
    precise float wind_force = area * wind;
    vec3 faces = vec3(0.0);
#if CORNER_QUADS
    faces = force_of_faces(vertex);
#endif
    vec3 a = acceleration(inverse_mass, mass, vec3(gravity_x, gravity_y, gravity_z), 0.0, velocity.xyz, faces,
                          wind_force);
    float keep = vbd_keep(inverse_mass, rho, substep);
    Motion free = vbd_free_motion(x, velocity.xyz, a, keep, substep);
    vec3 to = select_positive(inverse_mass, within_tethers(vertex, free.position), x);
    precise vec3 held_back = to - free.position;
    precise vec3 target = substep * free.velocity + select_positive(inverse_mass, held_back, vec3(0.0));
    precise float mobility = substep * substep * inverse_mass * keep;
    new_positions[vertex] = vec4(to, inverse_mass);
    moves[vertex] = vec4(target, 0.0);
    targets[vertex] = vec4(target, mobility);
}
