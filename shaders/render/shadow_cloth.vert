#version 430 core
// The cloth as the key light sees it on the floor.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/shadow_projection.glsl"

layout(location = ATTRIBUTE_POSITION) in vec3 position;

out float height;

void main()
{
    height = height_over_floor(position);
    gl_Position = on_shadow_square(position);
}
