// Boxes of displacements.
#include "collision/tree/motion_bound.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/task_share.h"

namespace nuno {
namespace {

constexpr std::size_t kVerticesInTask = 16384;
// Of the vertices, those that are looked at where some are enough: of most grids from all columns, of those with a
// multiple of this from one.
constexpr std::size_t kSomeStep = 17;
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

// Of the displacements; least and largest do not depend on the order.
struct Displaced
{
    Extent start, end;
};

// The diagonal of the box, at most.
double diagonal(const Extent& moved)
{
    const glm::dvec3 lo(moved.lo), hi(moved.hi);
    // A displacement is rounded by half of 2^-23 of its size.
    const glm::dvec3 size = glm::max(glm::abs(lo), glm::abs(hi));
    return glm::length(hi - lo) * (1 + 1e-9) + 2 * 0x1p-23 * (size.x + size.y + size.z);
}

}  // namespace

void MotionBound::note(const Poses& poses, std::size_t step)
{
    step_ = step;
    start_.clear();
    end_.clear();
    for (std::size_t v = 0; v < poses.t0.size(); v += step) {
        start_.push_back(poses.t0[v]);
        end_.push_back(poses.t1[v]);
    }
}

void MotionBound::note_query(const Poses& poses, float found_within)
{
    note(poses, 1);
    found_within_ = found_within;
}

void MotionBound::note_some(const Poses& poses)
{
    note(poses, kSomeStep);
    found_within_ = -std::numeric_limits<float>::infinity();
}

double MotionBound::relative_motion(const Poses& poses, ThreadPool& pool) const
{
    if (start_.empty()) return kInfinity;
    assert((poses.t0.size() + step_ - 1) / step_ == start_.size());
    std::vector<Displaced> parts((start_.size() + kVerticesInTask - 1) / kVerticesInTask);
    share_tasks(pool, static_cast<int>(parts.size()), [&](int task, int) {
        const std::size_t begin = static_cast<std::size_t>(task) * kVerticesInTask;
        Displaced moved;
        for (std::size_t v = begin; v < std::min(begin + kVerticesInTask, start_.size()); ++v) {
            moved.start.add(poses.t0[v * step_] - start_[v]);
            moved.end.add(poses.t1[v * step_] - end_[v]);
        }
        parts[static_cast<std::size_t>(task)] = moved;
    });
    Displaced all;
    for (const Displaced& part : parts) {
        all.start.add(part.start);
        all.end.add(part.end);
    }
    return std::max(diagonal(all.start), diagonal(all.end));
}

void MotionBound::carry(Archive& archive)
{
    archive.value(step_);
    archive.list(start_);
    archive.list(end_);
    archive.value(found_within_);
}

bool MotionBound::covers(const Poses& poses, float distance, ThreadPool& pool) const
{
    return relative_motion(poses, pool) + double(distance) <= double(found_within_);
}

}  // namespace nuno
