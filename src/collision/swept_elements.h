// Boxes around elements of a cloth at the start of a way, and around their motion: whether two of them may meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/float4.h"
#include "collision/tree/tree_node.h"
#include "core/thread_pool.h"

namespace nuno {

// Lanes 0, 1, 2 are x, y, z.
struct alignas(64) SweptElement
{
    Float4 lo, hi;          // of the corners at the start [m]
    Float4 way_lo, way_hi;  // of what they move by [m]
};

inline SweptElement hull(const SweptElement& a, const SweptElement& b)
{
    return {lesser(a.lo, b.lo), greater(a.hi, b.hi), lesser(a.way_lo, b.way_lo), greater(a.way_hi, b.way_hi)};
}

// Motion that two elements have in common brings them no nearer, so what is compared is the motion of one relative to
// the other: sharper than boxes around whole ways.
class SweptElements
{
  public:
    // Elements that come as near as `distance` [m] on the way of the poses may meet.
    void set(const Poses& poses, float distance, ThreadPool& pool);
    // The same poses with another distance.
    void set_distance(float distance);
    // Boxes of all faces at these poses, for face().
    void set_faces(std::span<const glm::uvec3> faces, ThreadPool& pool);

    bool is_swept() const { return is_swept_; }  // whether there is any motion
    const SweptElement& face(std::uint32_t face) const { return faces_[face]; }
    SweptElement face(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return hull(hull(vertex(a), vertex(b)), vertex(c));
    }
    SweptElement vertex(std::uint32_t vertex) const
    {
        const Float4 start = lanes_of(start_[vertex]), way = lanes_of(ways_[vertex]);
        return {start, start, way, way};
    }
    SweptElement edge(const glm::uvec2& ends) const { return hull(vertex(ends.x), vertex(ends.y)); }

    // False where they stay apart on some axis. On a straight way the distance of two boxes along an axis is least at
    // its start or its end.
    bool may_meet(const SweptElement& a, const SweptElement& b) const
    {
        const Float4 none = all_lanes(0);
        const Float4 above = (b.lo - a.hi) + lesser(b.way_lo - a.way_hi, none);
        const Float4 below = (a.lo - b.hi) + lesser(a.way_lo - b.way_hi, none);
        return (lane_bits((above <= distance_) & (below <= distance_)) & 7u) == 7u;
    }

    // The same of a vertex and another element where there is no motion.
    bool is_near(std::uint32_t vertex, const SweptElement& b) const
    {
        const Float4 at = lanes_of(start_[vertex]);
        return (lane_bits((b.lo - at <= distance_) & (at - b.hi <= distance_)) & 7u) == 7u;
    }

  private:
    std::span<const glm::vec4> start_;
    std::vector<glm::vec4> ways_;  // of every vertex
    std::vector<SweptElement> faces_;
    float largest_ = 0;  // coordinate [m]
    bool is_swept_ = false;
    Float4 distance_{};  // and what rounding may take away
};

}  // namespace nuno
