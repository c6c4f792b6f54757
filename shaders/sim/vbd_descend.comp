#version 430 core
// One step of vertex block descent of the vertices of one colour, in place: no two of them are neighbours, so none
// reads what this dispatch writes. One invocation a place.
// Defined by the caller: LIMITED (0, 1), and what sim/forces.glsl needs.
#include "shared/dialect.glsl"
#include "sim/forces.glsl"
#include "shared/euler.h"
#include "shared/vbd.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_ORDER) uniform isamplerBuffer order; // vertices by place; -1 where a place only fills up
layout(binding = UNIT_MOVES) uniform samplerBuffer old_moves;
layout(binding = UNIT_TARGETS) uniform samplerBuffer targets; // w: mobility
layout(std430, binding = BLOCK_POSITIONS) writeonly buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_MOVES) writeonly buffer Moves { vec4 moves[]; };
layout(location = LOCATION_FIRST_PLACE) uniform int first_place;
layout(location = LOCATION_END_PLACE) uniform int end_place;
layout(location = LOCATION_LONGEST) uniform float longest;
layout(location = LOCATION_STIFFER) uniform float stiffer;
layout(location = LOCATION_DAMPER) uniform float damper;

VertexBlock block_of(int vertex, vec3 x, vec3 move)
{
    VertexBlock sum = empty_block();
    for (int quad = 0; quad < SPRING_QUADS; ++quad) {
        int texel = quad * vertex_count + vertex;
        ivec4 n = texelFetch(neighbours, texel);
        vec4 s = texelFetch(spring_stiffness, texel), t = texelFetch(spring_tension, texel);
        vec4 axial = texelFetch(spring_axial, texel);
        for (int k = 0; k < 4; ++k) {
            precise vec3 d = texelFetch(old_positions, n[k]).xyz - x;
            sum = with_spring(sum, d, s[k], t[k], axial[k]);
#if LIMITED
            sum = with_limit(sum, d, t[k], axial[k], longest, stiffer);
#endif
#if DAMPED_SPRINGS
            precise vec3 w = texelFetch(old_moves, n[k]).xyz - move;
            precise float c = damper * axial[k];
            sum = with_damper(sum, d, w, c);
#endif
        }
    }
    return sum;
}

void main()
{
    int place = first_place + int(gl_GlobalInvocationID.x);
    if (place >= end_place) return;
    int vertex = texelFetch(order, place).x;
    if (vertex < 0) return;
    vec4 position = texelFetch(old_positions, vertex);
    vec3 move = texelFetch(old_moves, vertex).xyz;
    vec4 target = texelFetch(targets, vertex);
    vec3 newton = newton_step(block_of(vertex, position.xyz, move), target.xyz, move, target.w);
    precise vec3 new_move = move + newton;
    precise vec3 new_position = position.xyz + newton;
    new_positions[vertex] = vec4(new_position, position.w);
    moves[vertex] = vec4(new_move, 0.0);
}
