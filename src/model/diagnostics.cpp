// Energies, strain and speed of a state.
#include "model/diagnostics.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/force_model.h"

namespace nuno {
namespace {

double largest_strain(const ClothModel& model, const ClothState& state)
{
    double largest = 0;
    for (const Spring& spring : model.springs) {
        if (!is_thread(spring.kind)) continue;
        const double length =
            glm::distance(glm::dvec3(state.positions[spring.a]), glm::dvec3(state.positions[spring.b]));
        largest = std::max(largest, std::abs(length / double(spring.rest_length) - 1));
    }
    return largest;
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
    const std::vector<glm::dvec3> x(state.positions.begin(), state.positions.end());
    d.elastic_j = ForceModel(model, params).elastic_energy(x);
    d.max_strain = largest_strain(model, state);
    return d;
}

}  // namespace nuno
