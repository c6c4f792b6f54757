// Search for contacts in the tree of boxes.
//
// No contact is lost (Culling::none). Let vertex v be in contact with face F, with foot x4 = w0 x0 + w1 x1 + w2 x2.
// 1. Along each axis, x4 is within delta e of F's corners, e being their extent: a sum with every weight in
//    -delta .. 1 + delta and all together 1 is largest where one weight is 1 + delta, one -delta, one 0. And
//    |v - x4| <= epsilon, since face_foot measures the distance to x4 itself. So v is within delta e + epsilon of the
//    box of F's corners.
// 2. The boxes of the tree are grown by delta (own extent) + epsilon / 2, and v stands for a box of half side
//    epsilon / 2. So the box of v overlaps that of F, and lies inside that of any face with the corner v.
// 3. v is owned by a block A, which has a face with the corner v; F is in a block B. A node's box holds those of all
//    its faces, so the boxes of A and B overlap, or A is B; and so it is with the nodes above them. The query finds
//    (A, B).
// 4. For (A, B), v is tested against every face of B whose box overlaps that of v: so against F, whether or not other
//    faces of the two blocks share a vertex.
// Rounding moves x4 by less than 1e-6 of the extents, for which the margin has 1e-5, and the boxes by less than what
// BoxTree adds to them.
#include "collision/discrete.h"

#include <algorithm>
#include <cmath>

#include "collision/task_loop.h"
#include "model/formulas.h"

namespace nuno {
namespace {

constexpr float kRounding = 1e-5f;

// The contacts among `pairs`. One comparison takes the three weights and the distance, without a branch on each.
void append_contacts(std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions, const ContactRange& range,
                     std::span<const VertexFace> pairs, std::vector<Contact>& contacts)
{
    const float least = -range.edge_tolerance, most = 1.0f + range.edge_tolerance;
    const Float4 lowest = {least, least, least, 0}, highest = {most, most, most, range.thickness};
    for (const auto [vertex, face] : pairs) {
        const glm::uvec3 corners = faces[face];
        const formulas::FaceFoot foot =
            formulas::face_foot(positions[vertex], positions[corners.x], positions[corners.y], positions[corners.z]);
        const float distance = std::abs(foot.distance);
        const Float4 found = {foot.weights.x, foot.weights.y, foot.weights.z, distance};
        if (lane_bits((found >= lowest) & (found <= highest)) != 0xf) continue;
        contacts.push_back({vertex, face, foot.weights, foot.distance < 0 ? -foot.normal : foot.normal, distance});
    }
}

}  // namespace

BoxMargin contact_margin(const ContactRange& range)
{
    return {range.edge_tolerance + kRounding, 0.5f * range.thickness * (1.0f + kRounding)};
}

std::span<const Contact> ContactSearch::find(const BoxTree& tree, std::span<const glm::vec4> positions,
                                             const ContactRange& range, Culling culling, ThreadPool& pool)
{
    const int task_count = query_.begin(tree, culling);
    if (found_.size() < static_cast<std::size_t>(task_count)) found_.resize(task_count);
    for (std::vector<Contact>& found : found_) found.clear();
    const Float4 margin = all_lanes(contact_margin(range).absolute);
    const auto box_of = [&](std::uint32_t vertex) {
        const Float4 at = lanes_of(positions[vertex]);
        return Bounds{at - margin, at + margin};
    };
    run_tasks(pool, task_count, [&](int task) {
        append_contacts(tree.faces(), positions, range, query_.run(task, box_of), found_[task]);
    });

    contacts_.clear();
    for (const std::vector<Contact>& found : found_) contacts_.insert(contacts_.end(), found.begin(), found.end());
    std::sort(contacts_.begin(), contacts_.end(), comes_before);
    return contacts_;
}

}  // namespace nuno
