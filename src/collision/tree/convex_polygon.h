// The convex hull of points in the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace nuno {

class ConvexPolygon
{
  public:
    ConvexPolygon() = default;
    // Of points of which not all are on one line.
    static ConvexPolygon around(std::span<const glm::vec2> points);

    // Numbers of the points that are its corners, counter-clockwise; less than three where there is no inside.
    std::span<const std::uint32_t> corners() const { return corners_; }
    // Whether some of the segment is inside, not only on the rim.
    bool holds_some_of(glm::vec2 a, glm::vec2 b) const;

  private:
    std::vector<std::uint32_t> corners_;
    std::vector<glm::dvec2> places_;  // of the corners
};

// Twice the area to the left of a that b spans with it.
inline double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace nuno
