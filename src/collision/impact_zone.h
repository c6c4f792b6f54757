// Impacts of one pass, answered together by inelastic impulses with friction (D. Harmon et al., Robust treatment of
// simultaneous collisions, 2008, with inequalities, so that layers slide and part freely).
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_elements.h"

namespace nuno {

// Two elements that would meet on the way of a pass.
struct Impact
{
    ElementPair pair;
    double time;                    // in [0, 1]: not later than they meet
    glm::dvec3 normal;              // unit, from side B to side A at that time
    std::array<double, 4> weights;  // of the vertices in the closest points then, 1 in sum for A and -1 for B
    double target;                  // [m] that they are to be apart along the normal at the end
    double impulse = 0;             // so far, along the normal, never negative [m kg]
    glm::dvec3 drag{0};             // of friction so far [m kg]
};

// Coulomb's coefficients between layers, and the inverse masses [1/kg], one a vertex.
struct ImpactTerms
{
    double kinetic, resting;
    std::span<const double> inverse_masses;
};

// Moves `positions` [m], candidates for the end of a pass that began at `start`, until every impact is answered or a
// number of sweeps is done. Only the vertices of impacts move.
void answer_impacts(std::span<Impact> impacts, std::span<const glm::dvec3> start, const ImpactTerms& terms,
                    std::span<glm::dvec3> positions);

}  // namespace nuno
