// The shadow on the floor, as soft as what throws it is high: a wide look at the mask tells its mean height, and that
// the width over which to average. Each level of the mask is an average over twice the width of the one before.
layout(binding = UNIT_FLOOR_SHADOW) uniform sampler2D floor_mask;  // r: covered; g: covered, times how near the floor

// `at`: from the middle of the square that can show a shadow, each side -1 to 1.
float floor_shadow_at(vec2 at)
{
    vec2 uv = 0.5 + 0.5 * at;
    float metres = 2.0 * shadow_centre.w;
    float texels = float(textureSize(floor_mask, 0).x);
    float widest = 2.0 * key_map.z * 0.5 * SHADOW_HEIGHT / metres;
    vec2 seen = textureLod(floor_mask, uv, max(log2(widest * texels), 0.0)).rg;
    float height = SHADOW_HEIGHT * (1.0 - seen.g / max(seen.r, 1e-3));
    float width = 2.0 * key_map.z * height / metres;
    float level = log2(max(0.5 * width * texels, 1.0));
    // Four looks, half a width apart, hide the squares of a coarse level; none where there is no shadow.
    int count = seen.r > 0.0 ? 4 : 0;
    vec2 offset = 0.25 * max(width, 1.0 / texels) * vec2(1.0, 0.4);
    float shadow = 0.0;
    for (int i = 0; i < count; ++i) {
        shadow += textureLod(floor_mask, uv + offset, level).r;
        offset = vec2(-offset.y, offset.x);
    }
    return 0.25 * shadow;
}
