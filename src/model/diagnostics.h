// Energies, strain and speed of a state: what a report says about each frame.
#pragma once

#include <glm/vec3.hpp>

#include "model/cloth_model.h"
#include "model/cloth_state.h"

namespace nuno {

struct Diagnostics
{
    double kinetic_j = 0, gravity_j = 0, elastic_j = 0;
    double max_strain = 0;             // largest | length / rest length - 1 | of a structural spring
    double max_speed = 0;              // [m/s]
    glm::dvec3 lowest{0}, highest{0};  // corners of the bounding box [m]
    glm::dvec3 centroid{0};            // mass-weighted [m]
};

Diagnostics measure(const ClothModel& model, const ClothState& state, const SimParams& params);

}  // namespace nuno
