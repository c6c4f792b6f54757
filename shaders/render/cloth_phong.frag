#version 430 core
// Phong shading: light at every pixel on the side that is seen, times the texture, and a weak highlight.
#include "shared/render_bindings.h"
#include "render/view_block.glsl"
#include "render/lighting.glsl"
#include "render/srgb.glsl"

layout(binding = UNIT_CLOTH_TEXTURE) uniform sampler2D cloth_texture;
in vec3 world_position;
in vec3 world_normal;
in vec2 texture_uv;
out vec4 colour;

void main()
{
    vec3 n = normalize(world_normal);
    if (!gl_FrontFacing) n = -n;
    vec3 matte = light_on_cloth(n) * texture(cloth_texture, texture_uv).rgb;
    colour = to_srgb(matte + highlight_on(world_position, n));
}
