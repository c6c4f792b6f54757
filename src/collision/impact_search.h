// The impacts of a pass: which elements would meet on the straight way from its start to its end.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/impact_zone.h"

namespace nuno {

// What keeps elements apart for good, however little: a gap that no rounding closes [m]. Those nearer than twice that
// at the start may come half as near again.
constexpr double kLeastGap = 1e-5;

// The cloth on its way. What is tested is what is stored: positions are floats, [m].
struct PassWay
{
    std::span<const glm::vec4> start, ways, end;  // ways: end less start, rounded
};

// The impact of the pair on this way, if there is one: if it comes nearer than it may, by the test of
// collision/ccd/impact.h, which misses none. `target` is left 0. A pair that touches at the start already has an impact
// at time 0, whatever its way.
std::optional<Impact> find_impact(const ElementPair& pair, const PassWay& way);

// Appends those of the pairs, all of `kind` and at most kMostPairsAtOnce: most are ruled out many at a time.
void append_impacts(PairKind kind, std::span<const ElementPair> pairs, const PassWay& way, std::vector<Impact>& found);

// Whether the pair touches where it is.
bool touches(const ElementPair& pair, std::span<const glm::vec4> positions);

}  // namespace nuno
