// Level `speculative`: what may come closer than the cloth is thick until the next pass, found ahead so that solvers
// can keep it apart in every substep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_elements.h"
#include "model/layer_contact.h"

namespace nuno {

// The cloth at the start of a pass, and how it would go on by itself until its end.
struct ForeseenStep
{
    std::span<const glm::vec4> positions;  // xyz [m]
    std::span<const glm::vec4> foreseen;   // positions at the end of the pass, less the mean motion
};

// Positions moved for `duration` [s] by velocities less their mean.
std::vector<glm::vec4> foresee(std::span<const glm::vec4> positions, std::span<const glm::vec4> velocities,
                               float duration);

// By how much the boxes around positions and foreseen positions grow so that no contact below is missed [m].
float speculative_margin(float thickness);

// What decides how near two elements may come.
struct LayerRest
{
    std::span<const glm::vec3> positions;          // of every vertex at rest [m]
    std::span<const std::uint32_t> sheet_numbers;  // of every vertex: layers of different sheets have no rest distance
    float thickness;                               // [m]
};

// Appends the pair as a contact if it may come within `thickness` [m] of itself on this way: that far apart already, or
// nearing each other on a straight way past the plane between their closest points. Elements of one sheet keep no more
// than half of their distance at rest.
void append_speculative(const ElementPair& pair, const ForeseenStep& step, const LayerRest& rest,
                        std::vector<LayerContact>& contacts);

// [m] that the pair keeps from each other.
float kept_distance(const ElementPair& pair, const LayerRest& rest);

}  // namespace nuno
