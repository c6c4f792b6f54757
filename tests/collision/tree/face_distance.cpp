// Distance of two triangles: of their edges, of corners to the other's inside, or none where an edge pierces the other.
#include "collision/tree/face_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

double point_segment(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b)
{
    const double length_sq = glm::dot(b - a, b - a);
    const double t = length_sq > 0 ? std::clamp(glm::dot(p - a, b - a) / length_sq, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * (b - a));
}

// Either the feet of the common perpendicular lie inside both, or an end is nearest.
double segment_segment(glm::dvec3 a0, glm::dvec3 a1, glm::dvec3 b0, glm::dvec3 b1)
{
    double least = std::min(
        {point_segment(a0, b0, b1), point_segment(a1, b0, b1), point_segment(b0, a0, a1), point_segment(b1, a0, a1)});
    const glm::dvec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), area = uu * vv - uv * uv;
    if (area > 1e-18 * uu * vv) {
        const double s = (uv * glm::dot(v, w) - vv * glm::dot(u, w)) / area;
        const double t = (uu * glm::dot(v, w) - uv * glm::dot(u, w)) / area;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, glm::distance(a0 + s * u, b0 + t * v));
    }
    return least;
}

bool is_above(const glm::dvec3& point, const Triangle& t, const glm::dvec3& normal)
{
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 a = t[std::size_t(k)], b = t[std::size_t((k + 1) % 3)];
        if (glm::dot(glm::cross(b - a, point - a), normal) < 0) return false;
    }
    return true;
}

glm::dvec3 normal_of(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

double corners_to_inside(const Triangle& corners, const Triangle& t)
{
    const glm::dvec3 normal = normal_of(t);
    const double length = glm::length(normal);
    double least = std::numeric_limits<double>::infinity();
    if (!(length > 0)) return least;
    for (const glm::dvec3& p : corners)
        if (is_above(p, t, normal)) least = std::min(least, std::abs(glm::dot(p - t[0], normal)) / length);
    return least;
}

bool an_edge_pierces(const Triangle& edges, const Triangle& t)
{
    const glm::dvec3 normal = normal_of(t);
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 p = edges[std::size_t(k)], q = edges[std::size_t((k + 1) % 3)];
        const double before = glm::dot(p - t[0], normal), after = glm::dot(q - t[0], normal);
        if (before * after >= 0 || before == after) continue;
        if (is_above(p + before / (before - after) * (q - p), t, normal)) return true;
    }
    return false;
}

}  // namespace

double triangle_distance(const Triangle& a, const Triangle& b)
{
    if (an_edge_pierces(a, b) || an_edge_pierces(b, a)) return 0;
    double least = std::min(corners_to_inside(a, b), corners_to_inside(b, a));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            least = std::min(least, segment_segment(a[std::size_t(i)], a[std::size_t((i + 1) % 3)], b[std::size_t(j)],
                                                    b[std::size_t((j + 1) % 3)]));
    return least;
}

}  // namespace nuno
