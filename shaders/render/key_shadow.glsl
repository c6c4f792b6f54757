// Soft shadows in the key light: R. Fernando, Percentage-Closer Soft Shadows, 2005. The mean distance of what stands in
// the light, among some points of its map, gives the width of the penumbra; then so many comparisons over that width.
layout(binding = UNIT_KEY_COMPARED) uniform sampler2DShadow key_compared;
layout(binding = UNIT_KEY_DEPTH) uniform sampler2D key_depth;

const int search_count = 10;
const int penumbra_count = 14;
const float search_distance = 0.5;  // [m] penumbras grow with the distance of what throws them up to here
const float bias = 0.004;           // [m] towards the light

// A turn by the golden angle: with radii as roots of the count, points that fill a disc evenly (H. Vogel, 1979).
const mat2 golden_turn = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

// The part of the key light that reaches p [m], on a surface of unit normal n, whichever side of it is lit.
float key_light_at(vec3 p, vec3 n)
{
    float side = key_map.x;
    vec3 lit_side = dot(n, key_direction.xyz) < 0.0 ? -n : n;
    vec3 q = (to_key_map * vec4(p + bias * (lit_side + key_direction.xyz), 1.0)).xyz;
    // The depth of the surface itself changes by this over the map, no steeper than 3.
    vec3 m = mat3(to_key_map) * lit_side;
    vec2 slope = -m.xy / (KEY_DEPTH_SIDES * KEY_DEPTH_SIDES * min(m.z, -1e-4));
    slope *= min(1.0, 3.0 / (KEY_DEPTH_SIDES * max(length(slope), 1e-6)));
    float search = key_map.z * search_distance / side;
    float blockers = 0.0;
    float distances = 0.0;
    vec2 direction = vec2(1.0, 0.0);
    for (int i = 0; i < search_count; ++i) {
        vec2 offset = search * sqrt((float(i) + 0.5) / float(search_count)) * direction;
        float apart = q.z + dot(slope, offset) - textureLod(key_depth, q.xy + offset, 0.0).r;
        blockers += step(0.0, apart);
        distances += max(apart, 0.0);
        direction = golden_turn * direction;
    }
    float radius = key_map.z * KEY_DEPTH_SIDES * distances / max(blockers, 1.0);
    radius = clamp(radius, 1.2 / key_map.y, search);
    // Where nothing stands in the light there is nothing to compare.
    int count = blockers * key_map.w > 0.0 ? penumbra_count : 0;
    float lit = 0.0;
    for (int i = 0; i < count; ++i) {
        vec2 offset = radius * sqrt((float(i) + 0.5) / float(penumbra_count)) * direction;
        lit += textureLod(key_compared, vec3(q.xy + offset, q.z + dot(slope, offset)), 0.0);
        direction = golden_turn * direction;
    }
    return count > 0 ? lit / float(penumbra_count) : 1.0;
}
