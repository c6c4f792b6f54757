#version 430 core
// Smooth normals: for each vertex the sum of its faces' normals, weighted by area, in the order of the faces, made
// unit. Where FOLDS is defined, w is how much the cloth bends towards its normal, as a curvature [1/m].
#include "shared/render_bindings.h"
layout(local_size_x = NORMAL_GROUP_SIZE) in;

layout(binding = UNIT_NORMAL_POSITIONS) uniform samplerBuffer positions;
layout(binding = UNIT_CORNER_STARTS) uniform usamplerBuffer corner_starts;  // of each vertex, and the end of the last
layout(binding = UNIT_CORNERS) uniform usamplerBuffer corners;              // the two other vertices of a face, in its order
layout(std430, binding = BLOCK_NORMALS) writeonly buffer Normals { vec4 normals[]; };
layout(location = LOCATION_NORMAL_COUNT) uniform uint vertex_count;

void main()
{
    uint vertex = gl_GlobalInvocationID.x;
    if (vertex >= vertex_count) return;
    vec3 here = texelFetch(positions, int(vertex)).xyz;
    int first = int(texelFetch(corner_starts, int(vertex)).x);
    int end = int(texelFetch(corner_starts, int(vertex) + 1).x);
    vec3 sum = vec3(0.0);
#ifdef FOLDS
    vec3 away = vec3(0.0);
    float away_sq = 0.0;
#endif
    for (int i = first; i < end; ++i) {
        uvec2 others = texelFetch(corners, i).xy;
        vec3 a = texelFetch(positions, int(others.x)).xyz - here;
        vec3 b = texelFetch(positions, int(others.y)).xyz - here;
        sum += cross(a, b);
#ifdef FOLDS
        away += a + b;
        away_sq += dot(a, a) + dot(b, b);
#endif
    }
    float size = length(sum);
    // Faces without area have no direction; any one will do.
    vec3 n = size > 0.0 ? sum / size : vec3(0.0, 0.0, 1.0);
#ifdef FOLDS
    // A neighbour at distance d on an arc of curvature k stands k d^2 / 2 off the tangent plane.
    float fold = away_sq > 0.0 ? 2.0 * dot(away, n) / away_sq : 0.0;
#else
    const float fold = 0.0;
#endif
    normals[vertex] = vec4(n, fold);
}
