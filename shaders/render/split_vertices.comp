#version 430 core
// Vertices as they are drawn where textures have seams: each of the cloth, then its copies, all with the position and
// the normal of the vertex that they are.
#include "shared/render_bindings.h"
layout(local_size_x = NORMAL_GROUP_SIZE) in;

layout(binding = UNIT_SPLIT_POSITIONS) uniform samplerBuffer positions;
layout(binding = UNIT_SPLIT_NORMALS) uniform samplerBuffer normals;
layout(binding = UNIT_SPLIT_SOURCES) uniform usamplerBuffer sources;  // of each drawn vertex, that of the cloth
layout(std430, binding = BLOCK_SPLIT_POSITIONS) writeonly buffer SplitPositions { vec4 split_positions[]; };
layout(std430, binding = BLOCK_SPLIT_NORMALS) writeonly buffer SplitNormals { vec4 split_normals[]; };
layout(location = LOCATION_SPLIT_COUNT) uniform uint drawn_count;

void main()
{
    uint drawn = gl_GlobalInvocationID.x;
    if (drawn >= drawn_count) return;
    int vertex = int(texelFetch(sources, int(drawn)).x);
    split_positions[drawn] = texelFetch(positions, vertex);
    split_normals[drawn] = texelFetch(normals, vertex);
}
