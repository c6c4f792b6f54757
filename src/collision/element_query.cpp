// Tree and boxes of a query.
#include "collision/element_query.h"

#include <algorithm>

namespace nuno {

ElementQuery::ElementQuery(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces)
    : elements_(faces, static_cast<std::uint32_t>(rest_positions.size())),
      near_(elements_.near_pairs()),
      tree_(rest_positions, faces)
{
}

int ElementQuery::begin(std::span<const glm::vec4> positions_t0, std::span<const glm::vec4> positions_t1, float growth,
                        ThreadPool& pool)
{
    tree_.refit_swept(positions_t0, positions_t1, {0, growth}, pool);
    blocks_.open.assign(1, tree_.root());
    blocks_.found.clear();
    tree_.query(blocks_, Culling::none);
    boxes_.set(positions_t0, positions_t1, growth);
    const std::size_t tasks =
        (near_.size() + kNearPairs - 1) / kNearPairs + (blocks_.found.size() + kBlockPairs - 1) / kBlockPairs;
    return static_cast<int>(tasks);
}

}  // namespace nuno
