// SweptElements of all faces.
#include "collision/swept_elements.h"

#include <algorithm>

#include <glm/common.hpp>

#include "core/task_share.h"

namespace nuno {
namespace {

constexpr std::size_t kInTask = 4096;

int task_count(std::size_t size) { return static_cast<int>((size + kInTask - 1) / kInTask); }

}  // namespace

void SweptElements::set(const Poses& poses, float distance, ThreadPool& pool)
{
    start_ = poses.t0;
    is_swept_ = poses.is_swept();
    ways_.resize(start_.size());
    std::vector<float> largest(std::size_t(task_count(start_.size())));
    share_tasks(pool, task_count(start_.size()), [&](int task, int) {
        const std::size_t begin = std::size_t(task) * kInTask, end = std::min(begin + kInTask, start_.size());
        Float4 size = all_lanes(0);
        for (std::size_t v = begin; v < end; ++v) {
            const Float4 a = lanes_of(poses.t0[v]), b = lanes_of(poses.t1[v]);
            const Float4 way = b - a;
            std::memcpy(&ways_[v], &way, sizeof way);
            size = greater(size, greater(greater(a, -a), greater(b, -b)));
        }
        largest[std::size_t(task)] = std::max({size[0], size[1], size[2]});
    });
    largest_ = largest.empty() ? 0.0f : *std::max_element(largest.begin(), largest.end());
    set_distance(distance);
}

// Coordinates of size M are rounded by 2^-24 M at most, in a way, its difference to another, that of two corners, and
// the sum: less than 12 of these in all.
void SweptElements::set_distance(float distance)
{
    distance_ = all_lanes(distance * (1 + 0x1p-20f) + 0x1p-20f * largest_);
}

void SweptElements::set_faces(std::span<const glm::uvec3> faces, ThreadPool& pool)
{
    faces_.resize(faces.size());
    share_tasks(pool, task_count(faces.size()), [&](int task, int) {
        const std::size_t begin = std::size_t(task) * kInTask, end = std::min(begin + kInTask, faces.size());
        for (std::size_t f = begin; f < end; ++f) faces_[f] = face(faces[f].x, faces[f].y, faces[f].z);
    });
}

}  // namespace nuno
