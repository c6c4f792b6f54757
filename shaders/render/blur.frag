#version 430 core
// Softens a picture along one direction: binomial weights over nine texels, each pair read between its two.
#include "shared/render_bindings.h"

layout(binding = UNIT_BLUR_SOURCE) uniform sampler2D source;
layout(location = LOCATION_BLUR_STEP) uniform vec2 one_texel;  // along the direction, in texture coordinates
in vec2 corner;
out float softened;

void main()
{
    const float offset_1 = 1.3846153846;
    const float offset_2 = 3.2307692308;
    vec2 here = 0.5 + 0.5 * corner;
    softened = 0.2270270270 * texture(source, here).r +
               0.3162162162 * (texture(source, here + offset_1 * one_texel).r + texture(source, here - offset_1 * one_texel).r) +
               0.0702702703 * (texture(source, here + offset_2 * one_texel).r + texture(source, here - offset_2 * one_texel).r);
}
