// Level `speculative`: what may come closer than the cloth is thick until the next pass, found ahead so that solvers
// can keep it apart in every substep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_elements.h"
#include "collision/pair_sieve.h"
#include "collision/tree/tree_node.h"
#include "model/layer_contact.h"

namespace nuno {

inline bool sees_ahead(CollisionLevel level) { return level >= CollisionLevel::speculative; }

// What the query has to find for the contacts below; Culling::sound may leave out pairs that keep a tenth more than
// they have to on the whole way foreseen.
TreeSettings speculative_query(float thickness, Culling culling);

// What decides how near two elements may come.
struct LayerRest
{
    std::span<const glm::vec3> positions;          // of every vertex at rest [m]
    std::span<const std::uint32_t> sheet_numbers;  // of every vertex: layers of different sheets have no rest distance
    float thickness;                               // [m]
};

// [m] that the pair keeps from each other: the thickness, or a third of the distance at rest of two elements of one sheet.
float kept_distance(const ElementPair& pair, const LayerRest& rest);

// Contacts, and the largest way [m] of the vertices of one relative to each other.
struct SpeculativeContacts
{
    std::vector<LayerContact> contacts;
    float largest_approach = 0;
};

// Appends those of the pairs, all of `kind` and at most kMostPairsAtOnce, that may come within the distance they keep
// of each other on the way of the step: that near already, or nearing each other past the plane between their closest
// points (pair_sieve.h).
void append_speculative(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step,
                        const LayerRest& rest, SpeculativeContacts& found);

}  // namespace nuno
