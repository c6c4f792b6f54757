// First time at which a moving vertex meets a moving face, or two moving edges each other: none missed, none late.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/ccd/axis_gap.h"
#include "collision/ccd/four_points.h"

namespace nuno {

// Times are in [0, 1]: point i goes straight and evenly from t0[i] to t1[i]. Faces and edges are closed (their edges
// and ends belong to them) and may have no area or length. All coordinates must be finite.
//
// The exact time T of first contact is found to lie in [time, time + kImpactTimeBracket]; there is an answer exactly
// where there is a contact. See docs/ccd.md.
constexpr double kImpactTimeBracket = 1e-9;

// With a separation s > 0 (a length, in the unit of the coordinates): a time before which the distance is nowhere below
// s. Where there is an answer, the distance at that time is at most s (1 + kSeparationSlack), but for rounding of 1e-13
// of the size of the pair; none means that it stays above s all along. 0 where the start is that near already.
constexpr double kSeparationSlack = 1e-3;

// At most the distance of the pair, less by rounding only (as above); 0 for a pair in contact. A separation of at most
// half of it lets a pair that starts near go on moving.
double distance_at_least(PairKind kind, const FourPoints& points);

// What the functions below do where the axes do not tell the pair apart.
std::optional<double> impact_of_near_pair(PairKind kind, const FourPoints& t0, const FourPoints& t1);
std::optional<double> impact_of_near_pair(PairKind kind, const FourPoints& t0, const FourPoints& t1, double separation);

// Points: vertex, then the face's three.
inline std::optional<double> vertex_face_impact(const FourPoints& t0, const FourPoints& t1)
{
    if (has_axis_gap<PairKind::vertex_face>(t0, t1, 0.0)) return std::nullopt;
    return impact_of_near_pair(PairKind::vertex_face, t0, t1);
}
inline std::optional<double> vertex_face_impact(const FourPoints& t0, const FourPoints& t1, double separation)
{
    if (has_axis_gap<PairKind::vertex_face>(t0, t1, separation)) return std::nullopt;
    return impact_of_near_pair(PairKind::vertex_face, t0, t1, separation);
}

// Points: the ends of one edge, then those of the other.
inline std::optional<double> edge_edge_impact(const FourPoints& t0, const FourPoints& t1)
{
    if (has_axis_gap<PairKind::edge_edge>(t0, t1, 0.0)) return std::nullopt;
    return impact_of_near_pair(PairKind::edge_edge, t0, t1);
}
inline std::optional<double> edge_edge_impact(const FourPoints& t0, const FourPoints& t1, double separation)
{
    if (has_axis_gap<PairKind::edge_edge>(t0, t1, separation)) return std::nullopt;
    return impact_of_near_pair(PairKind::edge_edge, t0, t1, separation);
}

}  // namespace nuno
