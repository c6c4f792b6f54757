// A coloured spring of xpbd. Defined by the caller: LIMITED (0, 1). Include after shared/xpbd.h.

// Projects a spring whose ends are at a and b (w: inverse mass); number: SpringNumber of
// solver/xpbd/constraint_colours.h.
void project(vec4 number, inout vec4 a, inout vec4 b)
{
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
