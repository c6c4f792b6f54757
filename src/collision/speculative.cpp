// Contacts ahead of time.
#include "collision/speculative.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/formulas.h"

namespace nuno {
namespace {

// Layers that are not within so many times the distance they keep, after the motion foreseen, are left out.
constexpr float kReach = 1.5f;
// Elements that provably keep more than so many times that share of their distance at rest need not be looked at.
constexpr float kProvenShare = 1.1f;
// Of their distance at rest, what elements of one sheet keep at most: neighbours are no layers.
constexpr float kRestShare = 1.0f / 3;

float kind_of(const ElementPair& pair)
{
    return pair.kind == PairKind::vertex_face ? CONTACT_VERTEX_FACE : CONTACT_EDGE_EDGE;
}

// Whether the boxes of both elements at rest are further apart than `distance`.
bool is_far_at_rest(const ElementPair& pair, std::span<const glm::vec3> rest, float distance)
{
    const glm::uvec4& v = pair.vertices;
    const glm::vec3 &a = rest[v.x], &b = rest[v.y], &c = rest[v.z], &d = rest[v.w];
    const bool face = pair.kind == PairKind::vertex_face;
    const glm::vec3 first_lo = face ? a : glm::min(a, b), first_hi = face ? a : glm::max(a, b);
    glm::vec3 lo = glm::min(c, d), hi = glm::max(c, d);
    if (face) {
        lo = glm::min(lo, b);
        hi = glm::max(hi, b);
    }
    const glm::vec3 gap = glm::max(first_lo - hi, lo - first_hi);
    return std::max({gap.x, gap.y, gap.z}) > distance;
}

}  // namespace

TreeSettings speculative_query(float thickness, Culling culling)
{
    return {kReach * thickness, culling, kProvenShare * kRestShare};
}

float kept_distance(const ElementPair& pair, const LayerRest& rest)
{
    const glm::uvec4& v = pair.vertices;
    if (rest.sheet_numbers[v.x] != rest.sheet_numbers[v.w]) return rest.thickness;
    if (is_far_at_rest(pair, rest.positions, rest.thickness / kRestShare)) return rest.thickness;
    const auto x = [&](int i) { return rest.positions[v[i]]; };
    const float distance = glm::length(formulas::closest_of_layers(kind_of(pair), x(0), x(1), x(2), x(3)).separation);
    return std::min(kRestShare * distance, rest.thickness);
}

void append_speculative(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step,
                        const LayerRest& rest, SpeculativeContacts& found)
{
    std::array<ForeseenPair, kMostPairsAtOnce> foreseen;
    foresee_pairs(kind, pairs, step, kReach * rest.thickness, foreseen);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (foreseen[i].gap > kReach * rest.thickness) continue;
        const float kept = kept_distance(pairs[i], rest);
        if (foreseen[i].gap > kReach * kept) continue;
        found.contacts.push_back({pairs[i].vertices, foreseen[i].normal, kind_of(pairs[i]), kept});
        found.largest_approach = std::max(found.largest_approach, foreseen[i].approach);
    }
}

}  // namespace nuno
