// Numbers that sum up a state of cloth.
#include "support/measures.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

double distance(const glm::vec4& a, const glm::vec4& b) { return glm::distance(glm::dvec3(a), glm::dvec3(b)); }

}  // namespace

double rms_distance(const ClothState& a, const ClothState& b)
{
    double sum = 0;
    for (std::size_t v = 0; v < a.positions.size(); ++v) sum += std::pow(distance(a.positions[v], b.positions[v]), 2);
    return std::sqrt(sum / double(a.positions.size()));
}

double mean_distance(const ClothState& a, const ClothState& b)
{
    double sum = 0;
    for (std::size_t v = 0; v < a.positions.size(); ++v) sum += distance(a.positions[v], b.positions[v]);
    return sum / double(a.positions.size());
}

double largest_distance(const ClothState& a, const ClothState& b)
{
    double largest = 0;
    for (std::size_t v = 0; v < a.positions.size(); ++v)
        largest = std::max(largest, distance(a.positions[v], b.positions[v]));
    return largest;
}

double kinetic_energy(const ClothState& state)
{
    double sum = 0;
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        if (state.positions[v].w > 0) {
            const glm::dvec3 u(state.velocities[v]);
            sum += glm::dot(u, u) / (2 * double(state.positions[v].w));
        }
    return sum;
}

Momentum momentum(const ClothState& state)
{
    Momentum all;
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        if (state.positions[v].w > 0) {
            const glm::dvec3 p = glm::dvec3(state.velocities[v]) / double(state.positions[v].w);
            all.sum += p;
            all.size += glm::length(p);
        }
    return all;
}

double largest_thread_strain(const ClothModel& model, const ClothState& state)
{
    double largest = -1;
    for (const Spring& spring : model.springs)
        if (is_thread(spring.kind))
            largest = std::max(
                largest,
                distance(state.positions[spring.a], state.positions[spring.b]) / double(spring.rest_length) - 1);
    return largest;
}

double furthest_beyond(const ClothModel& model, const ClothState& state, std::uint32_t vertex)
{
    double furthest = 0;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        furthest = std::max(furthest, distance(state.positions[v], state.positions[vertex]) -
                                          double(glm::distance(model.rest_positions[v], model.rest_positions[vertex])));
    return furthest;
}

}  // namespace nuno
