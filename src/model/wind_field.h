// Moving air: a mean wind, and gusts that it carries along.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/sim_params.h"

namespace nuno {

// What kernels need to find the air's velocity at a time: at x [m] it is
//   wind + gust_speed gust_at(per_size x + offset, seed)          (shaders/shared/gust.h).
struct AirField
{
    glm::vec3 wind{0};     // [m/s]
    float gust_speed = 0;  // [m/s]
    glm::vec3 offset{0};   // in lattice cells, 0 .. period: how far the wind has carried the gusts, backwards
    float per_size = 0;    // lattice cells a metre
    std::uint32_t seed = 0;
};

// Frozen turbulence: the pattern of the gusts does not change while the mean wind carries it along, so that without a
// mean wind it stands still.
AirField air_field(const SimParams& params, double time_s);

// [m/s]
glm::dvec3 air_velocity(const AirField& field, const glm::dvec3& x);

}  // namespace nuno
