// Level `spheres`: every vertex is a sphere as wide as the cloth is thick, and spheres are kept apart.
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "collision/sphere_pairs.h"

namespace nuno {

struct SphereSettings
{
    float thickness;                  // [m] diameter of a sphere
    float friction, static_friction;  // Coulomb coefficients between layers
};

// The cloth at the end of a pass.
struct SphereStep
{
    std::span<const glm::vec4> positions;  // xyz [m], w the inverse mass [1/kg], 0 where pinned
    std::span<glm::vec4> velocities;       // xyz [m/s], corrected
    float duration;                        // [s] of a pass
};

// The speed [m/s] at which two spheres are to part whose centres are `distance` [m] from each other.
float parting_speed(float distance, const SphereSettings& settings, float duration);

// Impulses that may only push, pair after pair in the order given, a few times over, until no pair parts slower than
// at its parting_speed; with Coulomb friction.
void push_spheres_apart(std::span<const VertexPair> pairs, const SphereSettings& settings, const SphereStep& step);

}  // namespace nuno
