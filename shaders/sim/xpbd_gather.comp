#version 430 core
// Projects all springs at once (src/solver/xpbd/jacobi_springs.h): each vertex gathers what its springs ask of it. One
// invocation a vertex.
// Defined by the caller: SPRING_QUADS (slots of the table / 4), LIMITED (0, 1).
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_POSITIONS) uniform samplerBuffer old_positions; // w: inverse mass
layout(binding = UNIT_NEIGHBOURS) uniform isamplerBuffer neighbours;
layout(binding = UNIT_PULL) uniform samplerBuffer shares;
layout(binding = UNIT_PULL_LENGTH) uniform samplerBuffer share_lengths;
layout(binding = UNIT_LIMIT_PULL) uniform samplerBuffer limits;
layout(binding = UNIT_LIMIT_PULL_LENGTH) uniform samplerBuffer limit_lengths;
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= vertex_count) return;
    vec4 x = texelFetch(old_positions, vertex);
    vec3 sum = vec3(0.0);
    for (int quad = 0; quad < SPRING_QUADS; ++quad) {
        int texel = quad * vertex_count + vertex;
        ivec4 n = texelFetch(neighbours, texel);
        vec4 share = texelFetch(shares, texel), share_length = texelFetch(share_lengths, texel);
#if LIMITED
        vec4 limit = texelFetch(limits, texel), limit_length = texelFetch(limit_lengths, texel);
#endif
        for (int k = 0; k < 4; ++k) {
            precise vec3 d = texelFetch(old_positions, n[k]).xyz - x.xyz;
            float pull = spring_pull(d, share[k], share_length[k]);
#if LIMITED
            pull = max_real(pull, spring_pull(d, limit[k], limit_length[k]));
#endif
            precise vec3 with_spring = sum + pull * d;
            sum = with_spring;
        }
    }
    precise vec3 moved = x.xyz + x.w * sum;
    new_positions[vertex] = vec4(moved, x.w);
}
