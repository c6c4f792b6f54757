#version 430 core
// The cloth as the key light sees it.
#include "shared/render_bindings.h"
#include "render/fabric_block.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;

void main()
{
    gl_Position = vec4(2.0 * (to_key_map * vec4(position, 1.0)).xyz - 1.0, 1.0);
}
