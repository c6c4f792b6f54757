// Contacts ahead of time.
#include "collision/speculative.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/formulas.h"

namespace nuno {
namespace {

// Layers that are not within so many thicknesses of each other, after the motion foreseen, are left out.
constexpr float kReach = 1.5f;
// Of that motion, what is allowed for a normal that turns.
constexpr float kTurning = 0.3f;
// Of their distance at rest, what elements of one sheet keep at most: neighbours are no layers.
constexpr float kRestShare = 0.5f;
// Elements nearer than this [m] have no normal.
constexpr float kTouching = 1e-9f;

struct Corners
{
    glm::vec3 x[4];
};

Corners corners_of(const ElementPair& pair, std::span<const glm::vec4> positions)
{
    Corners c;
    for (int i = 0; i < 4; ++i) c.x[i] = glm::vec3(positions[pair.vertices[i]]);
    return c;
}

float kind_of(const ElementPair& pair)
{
    return pair.kind == PairKind::vertex_face ? CONTACT_VERTEX_FACE : CONTACT_EDGE_EDGE;
}

// The largest way of a vertex of one side relative to one of the other.
float largest_approach(float kind, const Corners& ways)
{
    const int first_b = kind == CONTACT_VERTEX_FACE ? 1 : 2;
    float largest = 0;
    for (int a = 0; a < first_b; ++a)
        for (int b = first_b; b < 4; ++b) largest = std::max(largest, glm::length(ways.x[b] - ways.x[a]));
    return largest;
}

// The least that layer_gap comes to on the way, pair of vertices by pair of vertices.
float least_gap(float kind, const glm::vec3& normal, const Corners& x, const Corners& ways)
{
    const int first_b = kind == CONTACT_VERTEX_FACE ? 1 : 2;
    float least = INFINITY;
    for (int a = 0; a < first_b; ++a)
        for (int b = first_b; b < 4; ++b)
            least = std::min(
                least, glm::dot(normal, x.x[a] - x.x[b]) + std::min(0.0f, glm::dot(normal, ways.x[a] - ways.x[b])));
    return least;
}

}  // namespace

std::vector<glm::vec4> foresee(std::span<const glm::vec4> positions, std::span<const glm::vec4> velocities,
                               float duration)
{
    glm::dvec3 mean(0);
    for (const glm::vec4& v : velocities) mean += glm::dvec3(v);
    mean /= double(std::max<std::size_t>(velocities.size(), 1));
    std::vector<glm::vec4> foreseen(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v)
        foreseen[v] = positions[v] + glm::vec4((glm::vec3(velocities[v]) - glm::vec3(mean)) * duration, 0);
    return foreseen;
}

float speculative_margin(float thickness) { return 0.5f * kReach * thickness; }

float kept_distance(const ElementPair& pair, const LayerRest& rest)
{
    const glm::uvec4& v = pair.vertices;
    if (rest.sheet_numbers[v.x] != rest.sheet_numbers[v.w]) return rest.thickness;
    const auto x = [&](int i) { return rest.positions[v[i]]; };
    const float distance = glm::length(formulas::closest_of_layers(kind_of(pair), x(0), x(1), x(2), x(3)).separation);
    return std::min(kRestShare * distance, rest.thickness);
}

void append_speculative(const ElementPair& pair, const ForeseenStep& step, const LayerRest& rest,
                        std::vector<LayerContact>& contacts)
{
    const float kind = kind_of(pair);
    const Corners x = corners_of(pair, step.positions);
    const formulas::ClosestPoints closest = formulas::closest_of_layers(kind, x.x[0], x.x[1], x.x[2], x.x[3]);
    const float distance = glm::length(closest.separation);
    if (distance < kTouching) return;

    Corners ways = corners_of(pair, step.foreseen);
    for (int i = 0; i < 4; ++i) ways.x[i] -= x.x[i];
    const float approach = largest_approach(kind, ways);
    if (distance > kReach * rest.thickness + approach) return;
    const glm::vec3 normal = closest.separation / distance;
    const float gap = least_gap(kind, normal, x, ways) - kTurning * approach;
    if (gap > kReach * rest.thickness) return;
    const float kept = kept_distance(pair, rest);
    if (gap <= kReach * kept) contacts.push_back({pair.vertices, normal, kind, kept});
}

}  // namespace nuno
