// Light on a matte surface of unit normal n, in parts; its colour times the sum is what the eye sees.
vec3 key_on(vec3 n)
{
    return max(dot(n, key_direction.xyz), 0.0) * key_light.rgb;
}

vec3 soft_on(vec3 n)
{
    vec3 fill = max(dot(n, fill_direction.xyz), 0.0) * fill_light.rgb;
    return fill + mix(ground_light.rgb, sky_light.rgb, 0.5 * n.y + 0.5);
}

vec3 light_on(vec3 n)
{
    return key_on(n) + soft_on(n);
}

// The same on one side of cloth, with the key light that comes through from the other.
vec3 light_on_cloth(vec3 n)
{
    return light_on(n) + key_light.w * key_on(-n);
}

// The highlight of a surface at p [m] (Blinn and Phong), of a strength and sharpness that cloth has.
vec3 highlight_on(vec3 p, vec3 n)
{
    vec3 half_way = normalize(key_direction.xyz + normalize(eye.xyz - p));
    float facing = step(0.0, dot(n, key_direction.xyz));
    return facing * 0.12 * pow(max(dot(n, half_way), 0.0), 24.0) * key_light.rgb;
}
