// Where the key light carries a point to on the floor.

// [m]
float height_over_floor(vec3 p)
{
    return dot(floor_plane.xyz, p) - floor_plane.w;
}

// A point [m] carried along the key light to the floor, in the square that can show a shadow, each side -1 to 1.
vec4 on_shadow_square(vec3 p)
{
    float along_light = height_over_floor(p) / dot(floor_plane.xyz, key_direction.xyz);
    vec3 q = p - along_light * key_direction.xyz - shadow_centre.xyz;
    return vec4(dot(q, floor_across.xyz), dot(q, floor_along.xyz), 0.0, shadow_centre.w);
}
