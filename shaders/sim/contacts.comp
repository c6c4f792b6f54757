#version 430 core
// Answers the contacts between layers at the end of a substep, colour by colour, in one work group, as
// src/solver/base/cpu_contacts.cpp does: few of them act at a time, and colours wait for each other.
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/body_shapes.h"
#include "shared/push_out.h"
#include "shared/closest_points.h"
#include "shared/layer_contact.h"

layout(local_size_x = CONTACT_GROUP) in;
struct LayerContact
{
    uvec4 vertices;
    vec3 normal;
    float kind;
    float thickness, acts, unused0, unused1;
};
layout(std430, binding = BLOCK_POSITIONS) coherent buffer Positions { vec4 positions[]; };
layout(std430, binding = BLOCK_VELOCITIES) readonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = BLOCK_CONTACT_VELOCITIES) writeonly buffer NewVelocities { vec4 new_velocities[]; };
layout(std430, binding = BLOCK_START_POSITIONS) buffer StartPositions { vec4 start_positions[]; };
layout(std430, binding = BLOCK_CONTACTS) coherent buffer Contacts { LayerContact contacts[]; };
layout(std430, binding = BLOCK_END_POSITIONS) buffer EndPositions { vec4 end_positions[]; };
layout(binding = UNIT_COLOURS) uniform usamplerBuffer colour_starts;
layout(location = LOCATION_SUBSTEP) uniform float substep;
layout(location = LOCATION_VERTEX_COUNT) uniform int vertex_count;
layout(location = LOCATION_COLOURS) uniform int colour_count;
layout(location = LOCATION_FRICTION) uniform vec2 friction; // kinetic, resting

vec3 way(uint vertex) { return positions[vertex].xyz - start_positions[vertex].xyz; }

// Vertices that are held stay as they are, bit for bit.
void move_by(uint vertex, vec3 push, float weight)
{
    vec4 x = positions[vertex];
    if (weight * x.w != 0.0) positions[vertex] = vec4(contact_position(x.xyz, push, weight, x.w), x.w);
}

void answer(int i)
{
    uvec4 v = contacts[i].vertices;
    vec4 x0 = positions[v.x], x1 = positions[v.y], x2 = positions[v.z], x3 = positions[v.w];
    ClosestPoints c = closest_of_layers(contacts[i].kind, x0.xyz, x1.xyz, x2.xyz, x3.xyz);
    vec3 normal = contact_normal(contacts[i].normal, c.separation);
    contacts[i].normal = normal;
    float mobility = contact_mobility(c, x0.w, x1.w, x2.w, x3.w);
    vec3 push = contact_push(normal, dot_product(normal, c.separation),
                             contact_way(c, way(v.x), way(v.y), way(v.z), way(v.w)),
                             ContactTerms(contacts[i].thickness, substep, Friction(friction.x, friction.y)), mobility);
    if (push == vec3(0.0)) return;
    move_by(v.x, push, c.w0);
    move_by(v.y, push, c.w1);
    move_by(v.z, push, c.w2);
    move_by(v.w, push, c.w3);
}

void main()
{
    int first = int(gl_LocalInvocationID.x);
    int end = int(texelFetch(colour_starts, colour_count).x);
    for (int i = first; i < end; i += CONTACT_GROUP) {
        uvec4 v = contacts[i].vertices;
        float gap = layer_gap(contacts[i].kind, contacts[i].normal, positions[v.x].xyz, positions[v.y].xyz,
                              positions[v.z].xyz, positions[v.w].xyz);
        contacts[i].acts = gap < contacts[i].thickness ? 1.0 : 0.0;
    }
    for (int vertex = first; vertex < vertex_count; vertex += CONTACT_GROUP) end_positions[vertex] = positions[vertex];
    for (int colour = 0; colour < colour_count; ++colour) {
        memoryBarrierBuffer();
        barrier();
        int colour_end = int(texelFetch(colour_starts, colour + 1).x);
        for (int i = int(texelFetch(colour_starts, colour).x) + first; i < colour_end; i += CONTACT_GROUP)
            if (contacts[i].acts > 0.0) answer(i);
    }
    memoryBarrierBuffer();
    barrier();
    for (int vertex = first; vertex < vertex_count; vertex += CONTACT_GROUP) {
        vec4 now = positions[vertex];
        vec4 velocity = velocities[vertex];
        vec3 end = end_positions[vertex].xyz;
        precise vec3 gain = (now.xyz - end) / substep;
        precise vec3 faster = velocity.xyz + gain;
        new_velocities[vertex] = now.xyz == end ? velocity : vec4(faster, velocity.w);
        start_positions[vertex] = now;
    }
}
