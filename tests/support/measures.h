// Numbers that sum up a state of cloth, in double.
#pragma once

#include <glm/vec3.hpp>

#include "model/cloth_model.h"
#include "model/cloth_state.h"

namespace nuno {

// Distances between the vertices of two states of one cloth [m].
double rms_distance(const ClothState& a, const ClothState& b);
double mean_distance(const ClothState& a, const ClothState& b);
double largest_distance(const ClothState& a, const ClothState& b);

// Of the vertices that are free [J].
double kinetic_energy(const ClothState& state);

// Of the free vertices [kg m/s], and the sum of its sizes vertex by vertex, which rounding is measured by.
struct Momentum
{
    glm::dvec3 sum{0};
    double size = 0;
};
Momentum momentum(const ClothState& state);

// The largest stretch of a thread, a spring along warp or weft: length over rest length less 1; -1 without threads.
double largest_thread_strain(const ClothModel& model, const ClothState& state);

// How much further the furthest of the vertices is from a point than it is at rest from a vertex [m].
double furthest_beyond(const ClothModel& model, const ClothState& state, std::uint32_t vertex);

}  // namespace nuno
