#version 430 core
// The mean of the samples of a pixel of the layer.
#include "shared/render_bindings.h"

layout(binding = UNIT_LAYER) uniform sampler2DMS layer;
layout(location = LOCATION_SAMPLE_COUNT) uniform int sample_count;
out vec4 colour;

void main()
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < sample_count; ++i) sum += texelFetch(layer, ivec2(gl_FragCoord.xy), i);
    colour = sum / float(sample_count);
}
