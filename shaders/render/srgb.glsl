// Linear light as the sRGB code values that the framebuffer holds.
vec4 to_srgb(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return vec4(mix(high, low, lessThanEqual(c, vec3(0.0031308))), 1.0);
}
