// Edges of one face alone, in order, held against their convex hull.
#include "collision/tree/rest_rim.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr double kMostRoughness = 1e-3;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// The vertices of the rim in their order around it; empty where there is not one rim.
std::vector<std::uint32_t> rim_of(std::span<const glm::uvec3> faces)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k)
            if (++sides[{face[k], face[(k + 1) % 3]}] > 1) return {};
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [side, count] : sides)
        if (!sides.contains({side.second, side.first}) && !next.emplace(side.first, side.second).second) return {};
    if (next.empty()) return {};
    std::vector<std::uint32_t> rim{next.begin()->first};
    for (std::uint32_t at = next.begin()->second; at != rim.front(); at = next[at]) {
        rim.push_back(at);
        if (rim.size() > next.size() || !next.contains(at)) return {};
    }
    return rim.size() == next.size() ? rim : std::vector<std::uint32_t>{};
}

// The corners of the convex hull counter-clockwise, as places in `rim` (Andrew's monotone chain).
std::vector<std::size_t> hull_of(std::span<const glm::dvec2> rim)
{
    std::vector<std::size_t> order(rim.size()), hull;
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rim[a].x != rim[b].x ? rim[a].x < rim[b].x : rim[a].y < rim[b].y;
    });
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const std::size_t k : order) {
            while (hull.size() > first + 1 &&
                   cross(rim[hull.back()] - rim[hull[hull.size() - 2]], rim[k] - rim[hull.back()]) <= 0)
                hull.pop_back();
            hull.push_back(k);
        }
        hull.pop_back();
        std::reverse(order.begin(), order.end());
    }
    return hull;
}

}  // namespace

std::optional<double> rim_roughness(std::span<const glm::dvec2> places, std::span<const glm::uvec3> faces)
{
    std::vector<glm::dvec2> rim;
    for (const std::uint32_t v : rim_of(faces)) rim.push_back(places[v]);
    if (rim.size() < 3) return std::nullopt;
    const std::vector<std::size_t> hull = hull_of(rim);
    if (hull.size() < 3) return std::nullopt;
    double roughness = 0;
    std::size_t walked = 0;
    for (std::size_t h = 0; h < hull.size(); ++h) {
        const std::size_t from = hull[h], to = hull[(h + 1) % hull.size()];
        const glm::dvec2 above = rim[to] - rim[from];
        for (std::size_t k = from; k != to; k = (k + 1) % rim.size()) {
            const glm::dvec2 edge = rim[(k + 1) % rim.size()] - rim[k];
            roughness = std::max(roughness, std::abs(std::atan2(cross(above, edge), glm::dot(above, edge))));
            if (++walked > rim.size()) return std::nullopt;
        }
    }
    // Once around, each edge along its hull edge: then the rim is a simple polygon, and faces that turn one way cover
    // it once.
    if (walked != rim.size() || !(roughness <= kMostRoughness)) return std::nullopt;
    return roughness;
}

}  // namespace nuno
