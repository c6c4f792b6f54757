// Linear light as the sRGB code values that the framebuffer holds, off by less than a fifth of one of 255: a
// polynomial of the root in place of the power 1 / 2.4, which takes longer.
vec4 to_srgb(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    vec3 low = 12.92 * c;
    vec3 r = sqrt(c);
    vec3 high = -0.0370047 + r * (1.4478993 + r * (-0.9448610 + r * (0.8427912 - r * 0.3095719)));
    return vec4(mix(high, low, lessThanEqual(c, vec3(0.0031308))), 1.0);
}
