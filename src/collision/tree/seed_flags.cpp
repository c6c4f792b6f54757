// Boxes of normals, from the cells up; flags, from the top down.
#include "collision/tree/seed_flags.h"

#include <algorithm>

#include <glm/common.hpp>

#include "core/task_share.h"
#include "model/formulas.h"

namespace nuno {
namespace {

constexpr std::uint32_t kNodesInTask = 1024;

}  // namespace

// A face without area may have any normal: opposite ones are in the box then, so nothing with such a face is skipped.
SeedFlags::NormalBox SeedFlags::of_cells(const TreeLayout& layout, std::span<const glm::uvec3> faces,
                                         std::span<const glm::vec4> positions, std::uint32_t node) const
{
    NormalBox box;
    for (std::size_t k = 0; k < 4; ++k) {
        const Cell& cell = layout.cells[4 * std::size_t(node) + k];
        for (std::size_t f = 0; f < 2 && !cell.is_absent(); ++f) {
            const glm::uvec3 face = faces[cell.face[f]];
            const glm::vec3 x0 = positions[face.x], x1 = positions[face.y], x2 = positions[face.z];
            const glm::vec3 area = formulas::area_vector(x0 - x2, x1 - x2);
            const float length = formulas::vector_length(area);
            const glm::vec3 normal = length > 0 ? area / length : glm::vec3(1);
            box.lo = glm::min(box.lo, length > 0 ? normal : -normal);
            box.hi = glm::max(box.hi, normal);
        }
    }
    return box;
}

// Whether all normals n of the box are less than 90 degrees from one axis d, the centre of the box: the least n.d over
// a box is reached at a corner. Then no two of them are 180 degrees apart, which is the seed's condition.
bool SeedFlags::within_half_space(const NormalBox& box)
{
    const glm::vec3 axis = box.lo + box.hi, least = glm::min(axis * box.lo, axis * box.hi);
    return least.x + least.y + least.z > 1e-5f;
}

void SeedFlags::mark(const TreeLayout& layout, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions,
                     ThreadPool& pool)
{
    const std::size_t levels = layout.levels.size();
    boxes_.resize(levels);
    flags_.resize(levels);
    for (std::size_t level = 0; level < levels; ++level) {
        boxes_[level].resize(layout.levels[level].size());
        flags_[level].resize(layout.levels[level].size());
    }
    const auto node_count = static_cast<std::uint32_t>(boxes_[0].size());
    share_tasks(pool, static_cast<int>((node_count + kNodesInTask - 1) / kNodesInTask), [&](int task, int) {
        const std::uint32_t begin = static_cast<std::uint32_t>(task) * kNodesInTask;
        for (std::uint32_t n = begin; n < std::min(begin + kNodesInTask, node_count); ++n)
            boxes_[0][n] = of_cells(layout, faces, positions, n);
    });
    for (std::size_t level = 1; level < levels; ++level)
        for (std::size_t child = 0; child < boxes_[level - 1].size(); ++child) {
            NormalBox& box = boxes_[level][child / 4];
            if (child % 4 == 0) box = {};
            box.lo = glm::min(box.lo, boxes_[level - 1][child].lo);
            box.hi = glm::max(box.hi, boxes_[level - 1][child].hi);
        }
    for (std::size_t level = levels; level-- > 0;)
        for (std::size_t n = 0; n < flags_[level].size(); ++n) {
            const bool above = level + 1 < levels && flags_[level + 1][n / 4] != 0;
            flags_[level][n] = above || within_half_space(boxes_[level][n]) ? 1 : 0;
        }
}

}  // namespace nuno
