#version 430 core
// Puts the moving pins where their handles are at the end of a substep, one invocation a pin.
#include "shared/bindings.h"

layout(local_size_x = GROUP_SIZE) in;
layout(binding = UNIT_PIN_VERTICES) uniform isamplerBuffer pin_vertices;
layout(binding = UNIT_PIN_STEPS) uniform samplerBuffer pin_steps;  // position, velocity of each pin, substep by substep
layout(std430, binding = BLOCK_POSITIONS) buffer NewPositions { vec4 new_positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) buffer NewVelocities { vec4 new_velocities[]; };
layout(location = LOCATION_FIRST_PIN) uniform int first_pin;  // of this substep
layout(location = LOCATION_PIN_COUNT) uniform int pin_count;

void main()
{
    int pin = int(gl_GlobalInvocationID.x);
    if (pin >= pin_count) return;
    int vertex = texelFetch(pin_vertices, pin).x;
    int texel = 2 * (first_pin + pin);
    new_positions[vertex].xyz = texelFetch(pin_steps, texel).xyz;
    new_velocities[vertex].xyz = texelFetch(pin_steps, texel + 1).xyz;
}
