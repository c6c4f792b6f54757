// The shadow on the floor, softened alike everywhere.
layout(binding = UNIT_FLOOR_SHADOW) uniform sampler2D floor_shadow;

// `at`: from the middle of the square that can show a shadow, each side -1 to 1.
float floor_shadow_at(vec2 at)
{
    return texture(floor_shadow, 0.5 + 0.5 * at).r;
}
