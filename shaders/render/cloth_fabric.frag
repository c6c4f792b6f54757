#version 430 core
// Woven cloth: threads, the sheen of their fibres, light that goes through, and what lies in the shadow of other folds.
#include "shared/render_bindings.h"
#include "shared/dialect.glsl"
#include "shared/sheen.h"
#include "render/view_block.glsl"
#include "render/fabric_block.glsl"
#include "render/lighting.glsl"
#include "render/key_shadow.glsl"
#include "render/display.glsl"

layout(binding = UNIT_CLOTH_TEXTURE) uniform sampler2D cloth_texture;
layout(binding = UNIT_WEAVE) uniform sampler2D weave;
in vec3 world_position;
in vec3 world_normal;
in float fold;
in vec2 texture_uv;
in vec2 weave_uv;
out vec4 colour;

// n tilted by the slopes of the threads along u and v. The tangents are what the screen tells of position and texture
// (C. Schueler, Normal Mapping without Precomputed Tangents, ShaderX 5, 2006).
vec3 tilted(vec3 n, vec2 slope)
{
    vec3 p_x = cross(dFdy(world_position), n);
    vec3 p_y = cross(n, dFdx(world_position));
    vec2 uv_x = dFdx(weave_uv);
    vec2 uv_y = dFdy(weave_uv);
    vec3 along_u = p_x * uv_x.x + p_y * uv_y.x;
    vec3 along_v = p_x * uv_x.y + p_y * uv_y.y;
    float longest_sq = max(dot(along_u, along_u), dot(along_v, along_v));
    return normalize(n - (slope.x * along_u + slope.y * along_v) * inversesqrt(max(longest_sq, 1e-20)));
}

float albedo_of_sheen(float cosine)
{
    return sheen_albedo(cosine, sheen_fit.x, sheen_fit.y, sheen_fit.z, sheen_fit.w);
}

void main()
{
    vec3 eye_direction = normalize(eye.xyz - world_position);
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 surface = side * normalize(world_normal);
    vec4 thread = texture(weave, weave_uv);
    // Seen from the back the surface is its own mirror image: what rose falls, and so do its slopes against u and v.
    vec3 n = tilted(surface, fabric.z * (thread.xy * (510.0 / 127.0) - 256.0 / 127.0));
    vec3 dye = texture(cloth_texture, texture_uv).rgb * mix(1.0, WEAVE_BRIGHTEST * thread.z, fabric.z);

    float cos_eye = clamp(dot(n, eye_direction), 0.05, 1.0);
    float cos_light = dot(n, key_direction.xyz);
    float cos_half = clamp(dot(n, normalize(eye_direction + key_direction.xyz)), 0.0, 1.0);
    float from_front = max(cos_light, 0.0);
    float sheen_light = sheen_reflection(clamp(cos_light, 0.01, 1.0), cos_eye, cos_half, fabric.y) * step(0.0, cos_light);
    float sheen_eye = albedo_of_sheen(cos_eye);
    // What the sheen takes, the threads below do not get, the same seen from light and eye (KHR_materials_sheen, glTF).
    float left = 1.0 - fabric.x * max(sheen_eye, albedo_of_sheen(from_front));
    vec3 sheen_colour = fabric.x * mix(vec3(1.0), dye, 0.5);

    // Of what the threads send out a part goes on through the cloth; both parts together are their colour.
    float through = key_light.w;
    vec3 seen_through = dye * dye / max(max(dye.r, max(dye.g, dye.b)), 1e-3);
    float from_back = max(-dot(surface, key_direction.xyz), 0.0);
    vec3 key = left * dye * from_front / (1.0 + through) + sheen_colour * (3.14159265 * sheen_light) +
               seen_through * (from_back * through / (1.0 + through));
    float openness = exp2(-0.06 * max(side * fold, 0.0));
    float weakest = 1.0 - fabric.x * sheen_eye;
    vec3 around = openness * soft_on(n) * (weakest * dye + sheen_colour * sheen_eye);
    colour = to_display(key_light_at(world_position, surface) * key * key_light.rgb + around);
}
