// Projected Gauss-Seidel over the impacts.
#include "collision/impact_zone.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "model/formulas.h"

namespace nuno {
namespace {

constexpr int kSweeps = 20;
// Corrections below this [m] end the sweeps.
constexpr double kDone = 1e-6;
struct Weighed
{
    double mobility;  // sum w^2 inverse_mass [1/kg], not too small
    double gap;       // along the normal now [m]
    glm::dvec3 way;   // of the closest points relative to each other [m]
};

Weighed weigh(const Impact& impact, std::span<const glm::dvec3> start, const ImpactTerms& terms,
              std::span<const glm::dvec3> positions)
{
    Weighed sum{0, 0, glm::dvec3(0)};
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t v = impact.pair.vertices[i];
        const double w = impact.weights[std::size_t(i)], m = terms.inverse_masses[v];
        sum.mobility += w * w * m;
        sum.gap += w * glm::dot(impact.normal, positions[v]);
        sum.way += w * (positions[v] - start[v]);
        largest = std::max(largest, m);
    }
    sum.mobility = std::max(sum.mobility, double(CONTACT_LEAST_MOBILITY) * largest);
    return sum;
}

// What friction takes [m kg], of an impact with this impulse: what would stop the layers across each other, `stopping`,
// where they bear that, else what they bear while they slide. After Coulomb:
//     |drag| <= resting impulse, or |drag| = kinetic impulse against the way.
glm::dvec3 coulomb_drag(const glm::dvec3& stopping, double impulse, const ImpactTerms& terms)
{
    const double length = glm::length(stopping);
    if (length <= std::max(terms.resting, terms.kinetic) * impulse) return stopping;
    return stopping * (terms.kinetic * impulse / length);
}

// The largest way that it moved anything [m].
double answer_one(Impact& impact, std::span<const glm::dvec3> start, const ImpactTerms& terms,
                  std::span<glm::dvec3> positions)
{
    const Weighed now = weigh(impact, start, terms, positions);
    if (now.mobility <= 0) return 0;
    const double before = impact.impulse;
    impact.impulse = std::max(0.0, before + (impact.target - now.gap) / now.mobility);
    const glm::dvec3 across = now.way - glm::dot(now.way, impact.normal) * impact.normal;
    const glm::dvec3 drag = coulomb_drag(impact.drag - across / now.mobility, impact.impulse, terms);
    const glm::dvec3 push = (impact.impulse - before) * impact.normal + (drag - impact.drag);
    if (push == glm::dvec3(0)) return 0;

    impact.drag = drag;
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t v = impact.pair.vertices[i];
        positions[v] += push * (impact.weights[std::size_t(i)] * terms.inverse_masses[v]);
    }
    return glm::length(push) * now.mobility;
}

}  // namespace

void answer_impacts(std::span<Impact> impacts, std::span<const glm::dvec3> start, const ImpactTerms& terms,
                    std::span<glm::dvec3> positions)
{
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        double largest = 0;
        for (Impact& impact : impacts) largest = std::max(largest, answer_one(impact, start, terms, positions));
        if (largest < kDone) return;
    }
}

}  // namespace nuno
