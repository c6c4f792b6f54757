#version 430 core
// Projects the springs of a few colours in place: those that hang together by them join at most four vertices, and one
// invocation takes such a quad (solver/xpbd/spring_quads.h). No two quads share a vertex, so none reads what this
// dispatch writes for another.
// Defined by the caller: LIMITED, FORTH, BACK (0, 1: colours in order, then in reverse), COLOURS (1 to 3).
#include "sim/xpbd_springs.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(binding = UNIT_ENDS) uniform isamplerBuffer corners;           // four vertices; -1 where none is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer lengths;         // length, share of both sides of a colour
layout(binding = UNIT_SHARES) uniform samplerBuffer limits;           // limit length, hardness of both
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first;
layout(location = LOCATION_PLACE_COUNT) uniform int count;
layout(location = LOCATION_FIRST_SIDES) uniform int first_sides;

// Both sides of a colour: a to b and c to d; a length below 0 where no spring is.
void project_sides(int texel, inout vec4 a, inout vec4 b, inout vec4 c, inout vec4 d)
{
    vec4 length = texelFetch(lengths, texel), limit = vec4(0.0);
#if LIMITED
    limit = texelFetch(limits, texel);
#endif
    vec4 new_a = a, new_b = b, new_c = c, new_d = d;
    project(vec4(length.xy, limit.xy), new_a, new_b);
    project(vec4(length.zw, limit.zw), new_c, new_d);
    bool on_first = length.x >= 0.0, on_second = length.z >= 0.0;
    a = on_first ? new_a : a;
    b = on_first ? new_b : b;
    c = on_second ? new_c : c;
    d = on_second ? new_d : d;
}

void main()
{
    int quad = int(gl_GlobalInvocationID.x);
    if (quad >= count) return;
    ivec4 at = texelFetch(corners, first + quad);
    vec4 x0 = texelFetch(old_positions, max(at.x, 0)), x1 = texelFetch(old_positions, max(at.y, 0));
    vec4 x2 = texelFetch(old_positions, max(at.z, 0)), x3 = texelFetch(old_positions, max(at.w, 0));
    int texel = first_sides + quad;
#if FORTH
    project_sides(texel, x0, x1, x2, x3);
#if COLOURS > 1
    project_sides(texel + count, x0, x2, x1, x3);
#endif
#if COLOURS > 2
    project_sides(texel + 2 * count, x0, x3, x1, x2);
#endif
#endif
#if BACK
#if COLOURS > 2
    project_sides(texel + 2 * count, x0, x3, x1, x2);
#endif
#if COLOURS > 1
    project_sides(texel + count, x0, x2, x1, x3);
#endif
    project_sides(texel, x0, x1, x2, x3);
#endif
    if (at.x >= 0) new_positions[at.x] = x0;
    if (at.y >= 0) new_positions[at.y] = x1;
    if (at.z >= 0) new_positions[at.z] = x2;
    if (at.w >= 0) new_positions[at.w] = x3;
}
