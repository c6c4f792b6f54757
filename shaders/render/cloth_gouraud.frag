#version 430 core
// Gouraud shading: the light of the side that is seen, times the texture.
#include "shared/render_bindings.h"
#include "render/srgb.glsl"

layout(binding = UNIT_CLOTH_TEXTURE) uniform sampler2D cloth_texture;
in vec3 front_light;
in vec3 back_light;
in vec2 texture_uv;
out vec4 colour;

void main()
{
    vec3 light = gl_FrontFacing ? front_light : back_light;
    colour = to_srgb(light * texture(cloth_texture, texture_uv).rgb);
}
