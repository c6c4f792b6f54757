// Where a cloth comes to rest, in double.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// A minimum of the potential energy reached from `x` by Newton's method within a trust region, each step by conjugate
// gradients; pinned vertices stay. Ends where no force is larger than `tolerance` times the weight of the cloth; fails
// the test where it does not get there.
std::vector<glm::dvec3> equilibrium(const ClothModel& model, const SimParams& params, std::vector<glm::dvec3> x,
                                    double tolerance = 1e-7);

// From the start positions of the model.
std::vector<glm::dvec3> equilibrium(const ClothModel& model, const SimParams& params);

}  // namespace nuno
