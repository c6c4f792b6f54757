// Andrew's monotone chain; a segment is cut at every side.
#include "collision/tree/convex_polygon.h"

#include <algorithm>
#include <numeric>

namespace nuno {

ConvexPolygon ConvexPolygon::around(std::span<const glm::vec2> points)
{
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto at = [&](std::uint32_t k) { return glm::dvec2(points[k]); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
    });
    ConvexPolygon polygon;
    std::vector<std::uint32_t>& hull = polygon.corners_;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const std::uint32_t k : order) {
            while (hull.size() > first + 1 &&
                   cross(at(hull.back()) - at(hull[hull.size() - 2]), at(k) - at(hull.back())) <= 0)
                hull.pop_back();
            hull.push_back(k);
        }
        hull.pop_back();
        std::reverse(order.begin(), order.end());
    }
    for (const std::uint32_t k : hull) polygon.places_.push_back(at(k));
    return polygon;
}

bool ConvexPolygon::holds_some_of(glm::vec2 a, glm::vec2 b) const
{
    double begin = 0, end = 1;  // of the segment, what is inside of all sides so far
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const glm::dvec2 corner = places_[k], side = places_[(k + 1) % places_.size()] - corner;
        const double of_a = cross(side, glm::dvec2(a) - corner), of_b = cross(side, glm::dvec2(b) - corner);
        if (of_a <= 0 && of_b <= 0) return false;
        if (of_a < 0) begin = std::max(begin, of_a / (of_a - of_b));
        if (of_b < 0) end = std::min(end, of_a / (of_a - of_b));
        if (begin >= end) return false;
    }
    return true;
}

}  // namespace nuno
