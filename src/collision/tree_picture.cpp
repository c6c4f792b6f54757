// The tree for pictures.
#include "collision/tree_picture.h"

#include "collision/discrete.h"
#include "collision/speculative.h"

namespace nuno {

std::vector<FaceBox> TreePicture::boxes(std::span<const glm::vec4> positions, float distance, int depth)
{
    TreeSettings settings;
    settings.distance = distance;
    tree_.refit({positions, positions}, settings, pool_);
    return tree_.node_boxes(depth);
}

std::vector<int> TreePicture::left_out(std::span<const glm::vec4> positions, const TreeSettings& settings)
{
    tree_.refit({positions, positions}, settings, pool_);
    return tree_.left_out();
}

TreeSettings contact_query(const SimParams& params, std::span<const glm::uvec3> faces,
                           std::span<const glm::vec4> positions)
{
    if (sees_ahead(params.collision)) return speculative_query(params.thickness, params.culling);
    TreeSettings settings;
    settings.distance = contact_reach({params.thickness, params.edge_tolerance}, faces, positions);
    settings.culling = params.culling;
    return settings;
}

}  // namespace nuno
