// The colour that is seen along a ray that meets nothing; `direction` is of unit length.
vec3 background(vec3 direction)
{
    float height = direction.y;
    vec3 above = mix(zenith_colour.rgb, horizon_colour.rgb, exp(-3.0 * max(height, 0.0)));
    vec3 below = mix(nadir_colour.rgb, horizon_colour.rgb, exp(-3.0 * max(-height, 0.0)));
    return height > 0.0 ? above : below;
}
