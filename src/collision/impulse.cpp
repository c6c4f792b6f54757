// The seed's impulses.
#include "collision/impulse.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace nuno {

// The seed, for four particles of mass m, with v4 = w0 v0 + w1 v1 + w2 v2 the velocity of the foot and an impulse I
// along n on the face, -I on the vertex:
//     inelastic, (v3' - v4').n = 0:                   I  = m (v3 - v4).n / (1 + w0^2 + w1^2 + w2^2)
//     push-out, (v3' - v4').n = (epsilon - d) / dt:   I' = I - m (epsilon - d) / (dt (1 + w0^2 + w1^2 + w2^2))
// With masses of their own, k_i = 1 / m_i, the corners change by -w_i k_i J n and the vertex by k_3 J n, where J = -I':
//     (v3' - v4').n = (v3 - v4).n + J (k_3 + w0^2 k_0 + w1^2 k_1 + w2^2 k_2)
//     J = ((epsilon - d) / dt - (v3 - v4).n) / (k_3 + w0^2 k_0 + w1^2 k_1 + w2^2 k_2)
// which is -I' for equal masses. As written, the seed's impulse also pulls back what parts faster than
// (epsilon - d) / dt, and so glues the cloth to itself; here an impulse only pushes.
float contact_impulse(const Contact& contact, const ContactParticles& particles, float thickness, float duration)
{
    const auto& v = particles.velocities;
    const auto& k = particles.inverse_masses;
    const glm::vec3 w = contact.weights;
    const float mobility = k[3] + w.x * w.x * k[0] + w.y * w.y * k[1] + w.z * w.z * k[2];
    if (mobility <= 0) return 0;
    const glm::vec3 v4 = w.x * v[0] + w.y * v[1] + w.z * v[2];
    const float missing = (thickness - contact.distance) / duration - glm::dot(v[3] - v4, contact.normal);
    return std::max(missing, 0.0f) / mobility;
}

void apply_impulses(std::span<const Contact> contacts, std::span<const glm::uvec3> faces,
                    std::span<const glm::vec4> positions, std::span<glm::vec4> velocities, float thickness,
                    float duration)
{
    for (const Contact& contact : contacts) {
        const glm::uvec3 face = faces[contact.face];
        const std::array<std::uint32_t, 4> vertices = {face.x, face.y, face.z, contact.vertex};
        ContactParticles particles;
        for (int i = 0; i < 4; ++i) {
            particles.velocities[i] = velocities[vertices[i]];
            particles.inverse_masses[i] = positions[vertices[i]].w;
        }
        const float impulse = contact_impulse(contact, particles, thickness, duration);
        const glm::vec3 w = contact.weights;
        const std::array<float, 4> shares = {-w.x, -w.y, -w.z, 1.0f};
        for (int i = 0; i < 4; ++i) {
            const float change = shares[i] * particles.inverse_masses[i] * impulse;
            velocities[vertices[i]] += glm::vec4(change * contact.normal, 0);
        }
    }
}

}  // namespace nuno
