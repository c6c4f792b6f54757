// What is drawn of linear light: exposed and tone-mapped where the look says so, then as sRGB codes.
#include "render/srgb.glsl"
#ifdef TONE_MAPPED
#include "render/tone_curve.glsl"
#endif

vec4 to_display(vec3 linear)
{
#ifdef TONE_MAPPED
    // Cloth that lets a part of its light through is then about as bright as in the other looks.
    const float exposure = 1.15;
    return to_srgb(tone_curve(exposure * linear));
#else
    return to_srgb(linear);
#endif
}
