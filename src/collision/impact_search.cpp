// One pair on its way.
#include "collision/impact_search.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "collision/ccd/impact.h"
#include "collision/pair_sieve.h"
#include "model/formulas.h"

namespace nuno {
namespace {

// Below this separation [m] the test without any is the sharper one.
constexpr double kLeastSeparation = 1e-9;

FourPoints points_of(const ElementPair& pair, std::span<const glm::vec4> positions)
{
    FourPoints x;
    for (int i = 0; i < 4; ++i) x[std::size_t(i)] = glm::dvec3(positions[pair.vertices[i]]);
    return x;
}

formulas_f64::ClosestPoints closest_points(PairKind kind, const FourPoints& x)
{
    return kind == PairKind::vertex_face ? formulas_f64::closest_vertex_face(x[0], x[1], x[2], x[3])
                                         : formulas_f64::closest_edge_edge(x[0], x[1], x[2], x[3]);
}

std::optional<double> time_of_impact(PairKind kind, const FourPoints& t0, const FourPoints& t1, double separation)
{
    if (separation < kLeastSeparation) return impact_of_near_pair(kind, t0, t1);
    return impact_of_near_pair(kind, t0, t1, separation);
}

// A direction across both elements where their distance has none.
glm::dvec3 normal_of(PairKind kind, const FourPoints& x)
{
    const glm::dvec3 across =
        kind == PairKind::vertex_face ? glm::cross(x[2] - x[1], x[3] - x[1]) : glm::cross(x[1] - x[0], x[3] - x[2]);
    const double length = glm::length(across);
    return length > 0 ? across / length : glm::dvec3(0, 1, 0);
}

}  // namespace

bool touches(const ElementPair& pair, std::span<const glm::vec4> positions)
{
    const FourPoints x = points_of(pair, positions);
    return impact_of_near_pair(pair.kind, x, x).has_value();
}

std::optional<Impact> find_impact(const ElementPair& pair, const PassWay& way)
{
    const FourPoints t0 = points_of(pair, way.start), t1 = points_of(pair, way.end);
    const bool apart = pair.kind == PairKind::vertex_face ? has_axis_gap<PairKind::vertex_face>(t0, t1, kLeastGap)
                                                          : has_axis_gap<PairKind::edge_edge>(t0, t1, kLeastGap);
    if (apart) return std::nullopt;
    const formulas_f64::ClosestPoints at_start = closest_points(pair.kind, t0);
    const double distance = glm::length(at_start.separation);
    const std::optional<double> time =
        time_of_impact(pair.kind, t0, t1, std::min(kLeastGap, 0.5 * distance_at_least(pair.kind, t0)));
    if (!time) return std::nullopt;

    FourPoints then;
    for (std::size_t i = 0; i < 4; ++i) then[i] = t0[i] + *time * (t1[i] - t0[i]);
    const formulas_f64::ClosestPoints closest = closest_points(pair.kind, then);
    const double gap = glm::length(closest.separation);
    // What is too near for a direction of its own keeps that of the start.
    glm::dvec3 normal = gap > kLeastSeparation        ? closest.separation / gap
                        : distance > kLeastSeparation ? at_start.separation / distance
                                                      : normal_of(pair.kind, t0);
    if (glm::dot(normal, at_start.separation) < 0) normal = -normal;
    return Impact{pair, *time, normal, {closest.w0, closest.w1, closest.w2, closest.w3}, 0};
}

void append_impacts(PairKind kind, std::span<const ElementPair> pairs, const PassWay& way, std::vector<Impact>& found)
{
    std::array<float, kMostPairsAtOnce> bounds;
    bound_distances(kind, pairs, {way.start, way.ways}, bounds);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (bounds[i] > static_cast<float>(kLeastGap)) continue;
        if (const std::optional<Impact> impact = find_impact(pairs[i], way)) found.push_back(*impact);
    }
}

}  // namespace nuno
