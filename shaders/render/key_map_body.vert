#version 430 core
// A body as the key light sees it.
#include "shared/render_bindings.h"
#include "render/fabric_block.glsl"
#include "render/placed_body.glsl"

void main()
{
    gl_Position = vec4(2.0 * (to_key_map * vec4(placed_position(), 1.0)).xyz - 1.0, 1.0);
}
