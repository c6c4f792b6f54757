// The gradient of the length of all contour segments, each vertex of the contour being the point where an edge goes
// through a face: Volino and Magnenat-Thalmann, Resolving surface collisions through intersection contour minimization,
// 2006. The equations are in docs/collision.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "collision/untangle_moves.h"

namespace nuno {
namespace {

constexpr double kMostLeverage = 4.0;   // of a shallow crossing, where a small move shifts it far
constexpr double kLeastContour = 1e-9;  // [m] segments below have no direction

// A point of the contour: where the edge p q goes through the face.
struct ContourPoint
{
    std::uint32_t p, q;
    glm::uvec3 face;
    double share;        // of the way from p to q
    glm::dvec3 weights;  // of the face's corners
    glm::dvec3 place, along, normal;
};

glm::dvec3 place_of(std::uint32_t vertex, std::span<const glm::vec4> positions)
{
    return glm::dvec3(positions[vertex]);
}

ContourPoint contour_point(const Tangle& tangle, const Crossing& crossing, std::span<const glm::uvec3> faces,
                           std::span<const glm::vec4> positions)
{
    ContourPoint point;
    point.p = edge_vertex(tangle, crossing, 0, faces);
    point.q = edge_vertex(tangle, crossing, 1, faces);
    point.face = faces[crossing.edge_of_first ? tangle.faces.b : tangle.faces.a];
    const glm::dvec3 p = place_of(point.p, positions), q = place_of(point.q, positions);
    const glm::dvec3 a = place_of(point.face.x, positions), b = place_of(point.face.y, positions),
                     c = place_of(point.face.z, positions);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double from = glm::dot(normal, p - a), to = glm::dot(normal, q - a);
    point.share = from == to ? 0.5 : from / (from - to);
    point.place = p + point.share * (q - p);
    point.along = unit_or_zero(q - p);
    point.normal = unit_or_zero(normal);
    const double area_sq = std::max(glm::dot(normal, normal), std::numeric_limits<double>::min());
    const auto weight = [&](const glm::dvec3& u, const glm::dvec3& v) {
        return glm::dot(glm::cross(u - point.place, v - point.place), normal) / area_sq;
    };
    point.weights = {weight(b, c), weight(c, a), 0};
    point.weights.z = 1 - point.weights.x - point.weights.y;
    return point;
}

// Let the contour go from X on along the unit vector R. X stays on the edge, direction E, and in the plane of the face,
// normal N. A move d of the edge moves X by d - E (N.d) / (N.E), a move of the face by E (N.d) / (N.E), so that the
// steepest way to shorten the segment is R - s N for the edge and s N for the face, s = (R.E) / (N.E).
void pull(const ContourPoint& x, const glm::dvec3& r, Directions& ways)
{
    const double across = glm::dot(x.normal, x.along), slope = glm::dot(r, x.along);
    const double most = kMostLeverage * std::abs(across);
    const double leverage = std::abs(slope) >= most ? std::copysign(kMostLeverage, slope * across) : slope / across;
    const glm::dvec3 of_edge = r - leverage * x.normal, of_face = leverage * x.normal;
    ways[x.p] += (1 - x.share) * of_edge;
    ways[x.q] += x.share * of_edge;
    for (int i = 0; i < 3; ++i) ways[x.face[i]] += x.weights[i] * of_face;
}

std::optional<std::uint32_t> common_vertex(const glm::uvec3& f, const glm::uvec3& g)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (f[i] == g[j]) return f[i];
    return std::nullopt;
}

// The segment of the contour in two faces ends where an edge goes through a face, or in a common vertex.
void pull_segment(const Tangle& tangle, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions,
                  Directions& ways)
{
    const ContourPoint x = contour_point(tangle, tangle.meeting.crossings[0], faces, positions);
    const std::optional<std::uint32_t> common = common_vertex(faces[tangle.faces.a], faces[tangle.faces.b]);
    if (tangle.meeting.crossing_count < 2 && !common) return;
    const auto direction_to = [&](const glm::dvec3& end) {
        const glm::dvec3 way = end - x.place;
        const double length = glm::length(way);
        return length > kLeastContour ? way / length : glm::dvec3(0);
    };
    if (tangle.meeting.crossing_count < 2) return pull(x, direction_to(place_of(*common, positions)), ways);
    const ContourPoint y = contour_point(tangle, tangle.meeting.crossings[1], faces, positions);
    const glm::dvec3 r = direction_to(y.place);
    pull(x, r, ways);
    pull(y, -r, ways);
}

}  // namespace

void add_contour_moves(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces,
                       std::span<const glm::vec4> positions, Directions& ways)
{
    for (const Tangle& tangle : tangles)
        if (tangle.meeting.kind == Meeting::crossing) pull_segment(tangle, faces, positions, ways);
}

}  // namespace nuno
