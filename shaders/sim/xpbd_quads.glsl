// Coloured springs of xpbd by fours of vertices (solver/xpbd/spring_quads.h).
// Defined by the caller: LIMITED (0, 1), MOST_COLOURS (1 to 3, of a quad). Include after shared/xpbd.h.
#include "sim/xpbd_springs.glsl"

layout(binding = UNIT_ENDS) uniform isamplerBuffer quads;     // four vertices; -1 where none is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer lengths; // length, share of both sides of a colour
layout(binding = UNIT_SHARES) uniform samplerBuffer limits;   // limit length, hardness of both

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

// The colours of a quad in their order; `texel` is its sides of the first, those of the next are `count` further on.
void project_forth(int colours, int texel, int count, inout vec4 x0, inout vec4 x1, inout vec4 x2, inout vec4 x3)
{
    project_sides(texel, x0, x1, x2, x3);
    if (MOST_COLOURS > 1 && colours > 1) project_sides(texel + count, x0, x2, x1, x3);
    if (MOST_COLOURS > 2 && colours > 2) project_sides(texel + 2 * count, x0, x3, x1, x2);
}

// In reverse.
void project_back(int colours, int texel, int count, inout vec4 x0, inout vec4 x1, inout vec4 x2, inout vec4 x3)
{
    if (MOST_COLOURS > 2 && colours > 2) project_sides(texel + 2 * count, x0, x3, x1, x2);
    if (MOST_COLOURS > 1 && colours > 1) project_sides(texel + count, x0, x2, x1, x3);
    project_sides(texel, x0, x1, x2, x3);
}
