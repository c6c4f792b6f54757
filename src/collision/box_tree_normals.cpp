// The seed's culling: the nodes of the tree that cannot hit themselves, if one goes by their normals.
#include <span>

#include "collision/box_tree.h"
#include "model/formulas.h"

namespace nuno {
namespace {

const Bounds kNoNormal = {all_lanes(1), all_lanes(-1)};
// Of a face without area, whose normal may be any: opposite normals are in it, so nothing with such a face is culled.
const Bounds kEveryNormal = {all_lanes(-1), all_lanes(1)};

Bounds unit_normal(const glm::uvec3& face, std::span<const glm::vec4> positions)
{
    const glm::vec3 x0 = positions[face.x], x1 = positions[face.y], x2 = positions[face.z];
    const glm::vec3 area = formulas::area_vector(x0 - x2, x1 - x2);
    const float length = formulas::vector_length(area);
    if (!(length > 0)) return kEveryNormal;
    const Float4 normal = lanes_of(glm::vec4(area / length, 0));
    return {normal, normal};
}

// Whether all normals n of the bound are less than 90 degrees from one axis d, the centre of the bound: the least n.d
// over a box is reached at a corner. Then no two of them are 180 degrees apart, which is the seed's condition.
bool within_half_space(const Bounds& bound)
{
    const Float4 axis = bound.lo + bound.hi;
    const Float4 a = axis * bound.lo, b = axis * bound.hi;
    const Float4 least = lesser(a, b);
    return least[0] + least[1] + least[2] > 1e-5f;
}

}  // namespace

void BoxTree::bound_normals(std::span<const glm::vec4> positions, ThreadPool& pool)
{
    normal_bounds_.resize(nodes_.size());
    culled_.resize(nodes_.size());
    bottom_up(pool, [&](std::uint32_t index) {
        Bounds bound = kNoNormal;
        for (const std::uint32_t child : nodes_[index].child) {
            if (child == kNoChild) break;
            bound = hull(bound, is_block(index) ? unit_normal(faces_[child], positions) : normal_bounds_[child]);
        }
        normal_bounds_[index] = bound;
        culled_[index] = within_half_space(bound);
    });
}

}  // namespace nuno
