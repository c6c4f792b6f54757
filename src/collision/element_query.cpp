// Tree and boxes of a query.
#include "collision/element_query.h"

namespace nuno {

ElementQuery::ElementQuery(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                           std::span<const Sheet> sheets, ElementKinds kinds)
    : elements_(faces, static_cast<std::uint32_t>(rest_positions.size()), kinds),
      near_(elements_.near_pairs()),
      tree_(rest_positions, faces, sheets)
{
}

int ElementQuery::begin(const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    tree_.refit(poses, settings, pool);
    tree_.query(pool);
    if (!tree_.is_proven_apart()) swept_.set(poses, elements_.faces(), settings.distance, pool);
    return static_cast<int>(near_tasks() + tree_.pairs().size());
}

std::uint64_t ElementQuery::near_pairs_culled() const
{
    if (tree_.is_proven_apart()) return near_.pairs.size();
    std::uint64_t count = 0;
    for (std::uint32_t face = 0; face < elements_.faces().size(); ++face)
        if (tree_.is_apart_from_neighbours(face)) count += near_.of(face).size();
    return count;
}

}  // namespace nuno
