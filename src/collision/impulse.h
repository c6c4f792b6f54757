// The seed's answer to a contact (section 2.5.2): an impulse between the vertex and the corners of the face.
#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/contact.h"

namespace nuno {

// The four particles of a contact: corners 0, 1, 2 of the face, and 3, the vertex.
struct ContactParticles
{
    std::array<glm::vec3, 4> velocities;  // [m/s]
    std::array<float, 4> inverse_masses;  // [1/kg], 0 where pinned
};

// The impulse [kg m/s] on the vertex along the contact's normal, shared out to the corners against it by their weights,
// that lets the two part at (thickness - distance) / duration [m/s]. 0, never less, where they already part so fast or
// faster, and where all four are pinned.
float contact_impulse(const Contact& contact, const ContactParticles& particles, float thickness, float duration);

// Gives every contact its impulse, one after the other in the order given, each from the velocities that the one before
// left (xyz [m/s]). positions.w is the inverse mass [1/kg]; `duration` [s] is the time in which the cloth is to move
// apart.
void apply_impulses(std::span<const Contact> contacts, std::span<const glm::uvec3> faces,
                    std::span<const glm::vec4> positions, std::span<glm::vec4> velocities, float thickness,
                    float duration);

}  // namespace nuno
