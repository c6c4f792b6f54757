#version 430 core
// Projects the springs of a few colours in place: those that hang together by them join at most four vertices, and one
// invocation takes such a quad (solver/xpbd/spring_quads.h). No two quads share a vertex, so none reads what this
// dispatch writes for another.
// Defined by the caller: LIMITED, FORTH, BACK (0, 1: colours in order, then in reverse), MOST_COLOURS (1 to 3: of each
// quad).
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"
#include "sim/xpbd_quads.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first;
layout(location = LOCATION_PLACE_COUNT) uniform int count;
layout(location = LOCATION_FIRST_SIDES) uniform int first_sides;

void main()
{
    int quad = int(gl_GlobalInvocationID.x);
    if (quad >= count) return;
    ivec4 at = texelFetch(quads, first + quad);
    vec4 x0 = texelFetch(old_positions, max(at.x, 0)), x1 = texelFetch(old_positions, max(at.y, 0));
    vec4 x2 = texelFetch(old_positions, max(at.z, 0)), x3 = texelFetch(old_positions, max(at.w, 0));
    if (FORTH == 1) project_forth(MOST_COLOURS, first_sides + quad, count, x0, x1, x2, x3);
    if (BACK == 1) project_back(MOST_COLOURS, first_sides + quad, count, x0, x1, x2, x3);
    if (at.x >= 0) new_positions[at.x].xyz = x0.xyz;
    if (at.y >= 0) new_positions[at.y].xyz = x1.xyz;
    if (at.z >= 0) new_positions[at.z].xyz = x2.xyz;
    if (at.w >= 0) new_positions[at.w].xyz = x3.xyz;
}
