// The coloured springs of xpbd. Defined by the caller: LIMITED (0, 1).
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"

layout(binding = UNIT_ENDS) uniform isamplerBuffer ends;      // two vertices; -1 where nothing is
layout(binding = UNIT_NUMBERS) uniform samplerBuffer numbers; // SpringNumber of solver/xpbd/constraint_colours.h

// Projects a spring whose ends are at a and b (w: inverse mass).
void project(int spring, inout vec4 a, inout vec4 b)
{
    vec4 number = texelFetch(numbers, spring);
    precise vec3 d = b.xyz - a.xyz;
#if LIMITED
    precise float excess = limited_excess(d, number.x, number.z, number.w);
#else
    precise float excess = spring_excess(d, number.x);
#endif
    precise float move = number.y * excess;
    precise vec3 new_a = a.xyz + (a.w * move) * d;
    precise vec3 new_b = b.xyz - (b.w * move) * d;
    a.xyz = new_a;
    b.xyz = new_b;
}
