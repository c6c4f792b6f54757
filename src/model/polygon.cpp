// Ears are cut off in the plane that fits the polygon.
#include "model/polygon.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace nuno {
namespace {

struct Corner
{
    glm::dvec2 place;
    std::uint32_t vertex;
};

// Twice the signed area.
double turn(const Corner& a, const Corner& b, const Corner& c)
{
    const glm::dvec2 u = b.place - a.place, v = c.place - a.place;
    return u.x * v.y - u.y * v.x;
}

// Seen against the mean normal, so that the polygon runs counter-clockwise; nothing where it has no area.
std::vector<Corner> flattened(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners)
{
    const glm::dvec3 origin = positions[corners[0]];
    const auto at = [&](std::size_t i) { return glm::dvec3(positions[corners[i % corners.size()]]) - origin; };
    glm::dvec3 normal(0);
    for (std::size_t i = 0; i < corners.size(); ++i) normal += glm::cross(at(i), at(i + 1));
    const double area = glm::length(normal);
    if (!(area > 0)) return {};
    normal /= area;
    const glm::dvec3 least = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(least, normal)), y = glm::cross(normal, x);
    std::vector<Corner> flat;
    for (std::size_t i = 0; i < corners.size(); ++i)
        flat.push_back({{glm::dot(at(i), x), glm::dot(at(i), y)}, corners[i]});
    return flat;
}

// Whether corner `k` can be cut off: it is convex, and no other corner lies in its triangle or on its rim.
bool is_ear(const std::vector<Corner>& left, std::size_t k)
{
    const std::size_t n = left.size(), before = (k + n - 1) % n, after = (k + 1) % n;
    const Corner &a = left[before], &b = left[k], &c = left[after];
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i == before || i == k || i == after) continue;
        const Corner& p = left[i];
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

std::vector<glm::uvec3> cut_quad(std::span<const glm::vec3> positions, const std::vector<Corner>& q)
{
    const auto diagonal_sq = [&](std::size_t i, std::size_t j) {
        const glm::vec3 along = positions[q[j].vertex] - positions[q[i].vertex];
        return glm::dot(along, along);
    };
    const bool inside_02 = turn(q[0], q[1], q[2]) > 0 && turn(q[0], q[2], q[3]) > 0;
    const bool inside_13 = turn(q[0], q[1], q[3]) > 0 && turn(q[1], q[2], q[3]) > 0;
    if (!inside_02 && !inside_13) return {};
    const auto face = [&](std::size_t i, std::size_t j, std::size_t k) {
        return glm::uvec3(q[i].vertex, q[j].vertex, q[k].vertex);
    };
    if (inside_02 && (!inside_13 || diagonal_sq(0, 2) < diagonal_sq(1, 3))) return {face(0, 1, 2), face(0, 2, 3)};
    return {face(0, 1, 3), face(1, 2, 3)};
}

}  // namespace

std::vector<glm::uvec3> cut_polygon(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners)
{
    if (corners.size() == 3) return {{corners[0], corners[1], corners[2]}};
    std::vector<Corner> left = flattened(positions, corners);
    if (left.size() == 4) return cut_quad(positions, left);
    std::vector<glm::uvec3> faces;
    while (left.size() > 3) {
        const std::size_t n = left.size();
        std::size_t best = n;
        double shortest = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double diagonal = glm::distance(left[(k + n - 1) % n].place, left[(k + 1) % n].place);
            if ((best < n && diagonal >= shortest) || !is_ear(left, k)) continue;
            best = k;
            shortest = diagonal;
        }
        if (best == n) return {};
        faces.emplace_back(left[(best + n - 1) % n].vertex, left[best].vertex, left[(best + 1) % n].vertex);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    if (left.size() == 3 && turn(left[0], left[1], left[2]) > 0)
        faces.emplace_back(left[0].vertex, left[1].vertex, left[2].vertex);
    return faces.size() + 2 == corners.size() ? faces : std::vector<glm::uvec3>();
}

}  // namespace nuno
