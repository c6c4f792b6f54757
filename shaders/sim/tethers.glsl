// The tethers of a vertex. Defined by the caller: TETHERED (0, 1). Include after sim/forces.glsl and shared/xpbd.h.
layout(binding = UNIT_ANCHORS) uniform isamplerBuffer anchors;              // two vertices each
layout(binding = UNIT_TETHER_LENGTHS) uniform samplerBuffer tether_lengths; // [m]

// x, but not past the tethers of the vertex; anchors are where old_positions has them.
vec3 within_tethers(int vertex, vec3 x)
{
#if TETHERED
    ivec2 anchor = texelFetch(anchors, vertex).xy;
    vec2 length = texelFetch(tether_lengths, vertex).xy;
    x = tethered(x, texelFetch(old_positions, anchor.x).xyz, length.x);
    x = tethered(x, texelFetch(old_positions, anchor.y).xyz, length.y);
#endif
    return x;
}
