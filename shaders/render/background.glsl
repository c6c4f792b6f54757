// The colour that is seen along a ray that meets nothing; `direction` is of unit length.
vec3 background(vec3 direction)
{
    float height = direction.y;
    vec3 far = height > 0.0 ? zenith_colour.rgb : nadir_colour.rgb;
    return mix(far, horizon_colour.rgb, exp(-3.0 * abs(height)));
}
