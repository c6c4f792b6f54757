#version 430 core
// The background where nothing else was drawn.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/background.glsl"
#include "render/display.glsl"

in vec2 corner;
out vec4 colour;

void main()
{
    colour = to_display(background(normalize(ray_forward.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz)));
}
