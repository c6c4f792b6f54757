// What the look `cloth` adds to the block View; the C++ side is src/render/fabric_block.h.
layout(std140, binding = BLOCK_FABRIC) uniform Fabric
{
    mat4 to_key_map;    // a point [m] to the map of the key light: texture coordinates and depth, each 0 to 1
    vec4 key_map;       // side [m]; texels along it; tangent of the light's half angle; 1 where there are shadows, else 0
    vec4 fabric;        // sheen: part, roughness; depth of the weave
    vec4 sheen_fit;     // c0 .. c3 of sheen_albedo
};
