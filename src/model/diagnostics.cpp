// Energies, strain and speed of a state.
#include "model/diagnostics.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/spring_weights.h"

namespace nuno {
namespace {

// Spring energy 1/2 axial (|d| - l0)^2 + 1/2 plate |d|^2 summed, and the largest strain of a thread.
void measure_springs(const ClothModel& model, const ClothState& state, const SimParams& params, Diagnostics& d)
{
    const std::vector<SpringWeight> weights = spring_weights(model, params);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Spring& spring = model.springs[i];
        const double length =
            glm::distance(glm::dvec3(state.positions[spring.a]), glm::dvec3(state.positions[spring.b]));
        const double stretch = length - double(spring.rest_length);
        d.elastic_j +=
            0.5 * (double(weights[i].axial) * stretch * stretch + double(weights[i].plate) * length * length);
        if (is_thread(spring.kind))
            d.max_strain = std::max(d.max_strain, std::abs(stretch) / double(spring.rest_length));
    }
}

}  // namespace

Diagnostics measure(const ClothModel& model, const ClothState& state, const SimParams& params)
{
    Diagnostics d;
    const glm::dvec3 gravity(params.gravity_x, params.gravity_y, params.gravity_z);
    double total_mass = 0;
    d.lowest = d.highest = glm::dvec3(state.positions.front());
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const glm::dvec3 x(state.positions[v]), u(state.velocities[v]);
        const double mass = double(model.areas[v]) * double(params.areal_density);
        d.kinetic_j += 0.5 * mass * glm::dot(u, u);
        d.gravity_j -= mass * glm::dot(gravity, x);
        d.max_speed = std::max(d.max_speed, glm::length(u));
        d.lowest = glm::min(d.lowest, x);
        d.highest = glm::max(d.highest, x);
        d.centroid += mass * x;
        total_mass += mass;
    }
    d.centroid /= total_mass;
    measure_springs(model, state, params, d);
    return d;
}

}  // namespace nuno
