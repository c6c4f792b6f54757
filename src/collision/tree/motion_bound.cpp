// Boxes of displacements.
#include "collision/tree/motion_bound.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "collision/tree/task_share.h"

namespace nuno {
namespace {

constexpr std::size_t kVerticesInTask = 16384;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Extent
{
    glm::vec4 lo{std::numeric_limits<float>::infinity()}, hi{-std::numeric_limits<float>::infinity()};

    void add(glm::vec4 p)
    {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void add(const Extent& other)
    {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
};

// Over body(vertex, extent) for all vertices; least and largest do not depend on the order.
template <class Body>
Extent extent_of(std::size_t vertex_count, ThreadPool& pool, const Body& body)
{
    std::vector<Extent> parts((vertex_count + kVerticesInTask - 1) / kVerticesInTask);
    share_tasks(pool, static_cast<int>(parts.size()), [&](int task, int) {
        const std::size_t begin = static_cast<std::size_t>(task) * kVerticesInTask;
        Extent extent;
        for (std::size_t v = begin; v < std::min(begin + kVerticesInTask, vertex_count); ++v) body(v, extent);
        parts[static_cast<std::size_t>(task)] = extent;
    });
    Extent all;
    for (const Extent& part : parts) all.add(part);
    return all;
}

}  // namespace

void MotionBound::note_query(const Poses& poses, float found_within)
{
    start_.assign(poses.t0.begin(), poses.t0.end());
    found_within_ = found_within;
}

double MotionBound::relative_motion(const Poses& poses, ThreadPool& pool) const
{
    if (start_.empty()) return kInfinity;
    assert(poses.t0.size() == start_.size() && poses.t1.size() == start_.size());
    const bool swept = poses.is_swept();
    const Extent moved = extent_of(start_.size(), pool, [&](std::size_t v, Extent& part) {
        part.add(poses.t0[v] - start_[v]);
        if (swept) part.add(poses.t1[v] - start_[v]);
    });
    const glm::dvec3 lo(moved.lo), hi(moved.hi);
    // A displacement is rounded by half of 2^-23 of its size.
    const glm::dvec3 size = glm::max(glm::abs(lo), glm::abs(hi));
    return glm::length(hi - lo) * (1 + 1e-9) + 2 * 0x1p-23 * (size.x + size.y + size.z);
}

bool MotionBound::covers(const Poses& poses, float distance, ThreadPool& pool) const
{
    return relative_motion(poses, pool) + double(distance) <= double(found_within_);
}

}  // namespace nuno
