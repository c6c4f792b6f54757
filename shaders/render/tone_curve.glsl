// Light of any brightness as colours of a screen: the Khronos PBR Neutral tone mapper, by the formulas of its
// specification (KhronosGroup/ToneMapping, PBR_Neutral, 2024). Colours up to 0.8 stay what they are, less 0.04 that a
// glossy surface would add; brighter ones are compressed below 1 and lose colour.
vec3 tone_curve(vec3 light)
{
    const float f90 = 0.04;
    const float start = 0.8 - f90;
    const float desaturation = 0.15;
    float least = min(light.r, min(light.g, light.b));
    float offset = least < 2.0 * f90 ? least - least * least / (4.0 * f90) : f90;
    vec3 c = light - offset;
    float peak = max(c.r, max(c.g, c.b));
    float compressed = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
    float kept = 1.0 / (desaturation * (peak - compressed) + 1.0);
    vec3 bright = mix(vec3(compressed), c * (compressed / max(peak, start)), kept);
    return peak > start ? bright : c;
}
