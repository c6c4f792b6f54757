// The answer of level `spheres`.
//
// Overlap is answered by a velocity, so that the solver moves the cloth in its substeps and keeps its springs and
// constraints meanwhile. Were the vertices moved at once, whatever of it stretches the cloth would come back as energy:
// a constraint that is put right by d within a substep of h seconds gives d / h, and piles of cloth never come to rest.
#include "collision/spheres.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// Times that all pairs are gone through.
constexpr int kSweeps = 4;
// The share of an overlap that a pass is to end, and the speed [m/s] at which spheres part at most.
constexpr float kOverlapShare = 0.3f, kFastestParting = 0.25f;
// Spheres whose centres are nearer than this [m] part along y.
constexpr float kSameCentre = 1e-9f;

// A pair with the impulses [kg m/s] that it has been given so far: `normal` along n, never less than 0, and `tangent`.
struct PairImpulse
{
    glm::vec3 n;   // unit, from b to a
    float target;  // parting speed
    float normal;
    glm::vec3 tangent;
};

// What friction leaves of an impulse that would end all sliding: all of it up to mu_s times the normal one, else mu_k
// times the normal one.
float friction_share(float tangent, float normal, const SphereSettings& settings)
{
    if (tangent <= std::max(settings.static_friction, settings.friction) * normal) return 1;
    return settings.friction * normal / tangent;
}

// Sequential impulses (Catto, Iterative Dynamics with Temporal Coherence, 2005), with k = 1 / m: the sum J of a pair's
// impulses becomes what brings the speed along n to the target u, but is never less than 0,
//     J' = max(0, J + (u - (v_a - v_b).n) / (k_a + k_b)),
// and that of friction what ends the sliding, cut to what J' allows.
void sweep(std::span<const VertexPair> pairs, const SphereSettings& settings, const SphereStep& step,
           std::vector<PairImpulse>& impulses)
{
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [a, b] = pairs[i];
        const float ka = step.positions[a].w, kb = step.positions[b].w;
        if (ka + kb <= 0) continue;
        glm::vec4 &va = step.velocities[a], &vb = step.velocities[b];
        PairImpulse& sum = impulses[i];
        const auto push = [&](const glm::vec3& impulse) {
            va += glm::vec4(ka * impulse, 0);
            vb -= glm::vec4(kb * impulse, 0);
        };
        const float parting = glm::dot(glm::vec3(va) - glm::vec3(vb), sum.n);
        const float normal = std::max(sum.normal + (sum.target - parting) / (ka + kb), 0.0f);
        push((normal - sum.normal) * sum.n);
        sum.normal = normal;

        const glm::vec3 v = glm::vec3(va) - glm::vec3(vb), sliding = v - glm::dot(v, sum.n) * sum.n;
        glm::vec3 tangent = sum.tangent - sliding / (ka + kb);
        tangent *= friction_share(glm::length(tangent), normal, settings);
        push(tangent - sum.tangent);
        sum.tangent = tangent;
    }
}

}  // namespace

float parting_speed(float distance, const SphereSettings& settings, float duration)
{
    return std::clamp(kOverlapShare * (settings.thickness - distance) / duration, 0.0f, kFastestParting);
}

void push_spheres_apart(std::span<const VertexPair> pairs, const SphereSettings& settings, const SphereStep& step)
{
    std::vector<PairImpulse> impulses(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const glm::vec3 way = glm::vec3(step.positions[pairs[i].a]) - glm::vec3(step.positions[pairs[i].b]);
        const float distance = glm::length(way);
        impulses[i] = {distance > kSameCentre ? way / distance : glm::vec3(0, 1, 0),
                       parting_speed(distance, settings, step.duration), 0, glm::vec3(0)};
    }
    for (int i = 0; i < kSweeps; ++i) sweep(pairs, settings, step, impulses);
}

}  // namespace nuno
