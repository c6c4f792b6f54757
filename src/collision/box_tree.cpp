// Topology and refit of the tree of boxes.
#include "collision/box_tree.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

#include "collision/task_loop.h"

namespace nuno {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Bounds kEmptyBox = {all_lanes(kInfinity), all_lanes(-kInfinity)};

// Meshes with fewer faces are refitted and queried in less time than it takes to wake a thread.
constexpr std::uint32_t kLargeFaceCount = 4096;
// Subtrees of a large mesh, about: enough that threads end together, whatever their number.
constexpr std::uint32_t kSubtreeCount = 32;

int longest_axis(std::span<const std::uint32_t> faces, std::span<const glm::vec3> centroids)
{
    glm::vec3 lo(kInfinity), hi(-kInfinity);
    for (const std::uint32_t face : faces) {
        lo = glm::min(lo, centroids[face]);
        hi = glm::max(hi, centroids[face]);
    }
    const glm::vec3 extent = hi - lo;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

// The box grown by the margin, and by a quarter of a millionth of its coordinates for their rounding.
Bounds grown(const Bounds& box, BoxMargin margin)
{
    const Float4 growth = all_lanes(margin.relative) * (box.hi - box.lo) + all_lanes(margin.absolute) +
                          all_lanes(0x1p-22f) * greater(-box.lo, box.hi);
    return {box.lo - growth, box.hi + growth};
}

Bounds corner_box(const glm::uvec3& face, std::span<const glm::vec4> positions)
{
    const Float4 a = lanes_of(positions[face.x]), b = lanes_of(positions[face.y]), c = lanes_of(positions[face.z]);
    return {lesser(lesser(a, b), c), greater(greater(a, b), c)};
}

}  // namespace

// Splits a range of faces into four again and again. Every child but the last of a node holds `capacity` faces, a power
// of 4, so that nearly every node has its four children; the same capacity at the same depth puts all blocks at one
// depth.
struct BoxTree::Builder
{
    BoxTree& tree;
    std::vector<glm::vec3> centroids;  // of the faces
    std::vector<std::uint32_t> order;  // of the faces, from block to block
    std::vector<bool> has_owner;       // of the vertices

    std::uint32_t add_node(std::uint32_t begin, std::uint32_t end, std::uint32_t capacity)
    {
        const auto index = static_cast<std::uint32_t>(tree.nodes_.size());
        const auto first_vertex = static_cast<std::uint32_t>(tree.vertices_.size());
        tree.nodes_.emplace_back();
        tree.nodes_[index].child.fill(kNoChild);
        int slot = 0;
        split(begin, end, capacity, index, slot);

        Node& node = tree.nodes_[index];
        node.lo.fill(kEmptyBox.lo);
        node.hi.fill(kEmptyBox.hi);
        node.end = static_cast<std::uint32_t>(tree.nodes_.size());
        node.face_count = end - begin;
        node.first_vertex = first_vertex;
        node.end_vertex = static_cast<std::uint32_t>(tree.vertices_.size());
        return index;
    }

    // Halves the range until each part fits into one child.
    void split(std::uint32_t begin, std::uint32_t end, std::uint32_t capacity, std::uint32_t parent, int& slot)
    {
        if (end - begin <= capacity) {
            const std::uint32_t child = capacity == 1 ? add_face(order[begin]) : add_node(begin, end, capacity / 4);
            tree.nodes_[parent].child[slot++] = child;
            return;
        }
        const std::uint32_t child_count = (end - begin + capacity - 1) / capacity;
        const std::uint32_t middle = begin + capacity * ((child_count + 1) / 2);
        const int axis = longest_axis(std::span(order).subspan(begin, end - begin), centroids);
        const auto less = [&](std::uint32_t a, std::uint32_t b) {
            return centroids[a][axis] != centroids[b][axis] ? centroids[a][axis] < centroids[b][axis] : a < b;
        };
        std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, less);
        split(begin, middle, capacity, parent, slot);
        split(middle, end, capacity, parent, slot);
    }

    std::uint32_t add_face(std::uint32_t face)
    {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = tree.faces_[face][corner];
            if (!has_owner[vertex]) tree.vertices_.push_back(vertex);
            has_owner[vertex] = true;
        }
        return face;
    }
};

BoxTree::BoxTree(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces)
    : faces_(faces.begin(), faces.end())
{
    assert(!faces.empty());
    Builder builder{*this, {}, {}, std::vector<bool>(rest_positions.size())};
    for (const glm::uvec3& face : faces) {
        assert(std::max({face.x, face.y, face.z}) < rest_positions.size());
        builder.centroids.push_back((rest_positions[face.x] + rest_positions[face.y] + rest_positions[face.z]) / 3.0f);
    }
    builder.order.resize(faces.size());
    std::iota(builder.order.begin(), builder.order.end(), 0u);

    std::uint32_t capacity = 1;
    while (4 * capacity < faces.size()) capacity *= 4;
    builder.add_node(0, static_cast<std::uint32_t>(faces.size()), capacity);
    boxes_.assign(nodes_.size(), kEmptyBox);
    share_out();
}

// The partition of the refit is a property of the mesh, so the result does not depend on the number of threads.
void BoxTree::share_out()
{
    const bool large = faces_.size() >= kLargeFaceCount;
    for (std::uint32_t index = 0; index < nodes_.size();) {
        const bool apart = large && nodes_[index].face_count <= faces_.size() / kSubtreeCount;
        (apart ? subtrees_ : top_nodes_).push_back(index);
        index = apart ? nodes_[index].end : index + 1;
    }
}

void BoxTree::bottom_up(ThreadPool& pool, const std::function<void(std::uint32_t node)>& body) const
{
    run_tasks(pool, static_cast<int>(subtrees_.size()), [&](int task) {
        const std::uint32_t first = subtrees_[task];
        for (std::uint32_t index = nodes_[first].end; index-- > first;) body(index);
    });
    for (auto index = top_nodes_.rbegin(); index != top_nodes_.rend(); ++index) body(*index);
}

template <class FaceBox>
void BoxTree::refit_nodes(ThreadPool& pool, BoxMargin margin, const FaceBox& face_box)
{
    bottom_up(pool, [&](std::uint32_t index) {
        Node& node = nodes_[index];
        const bool block = is_block(index);
        Bounds all = kEmptyBox;
        for (int slot = 0; slot < 4 && node.child[slot] != kNoChild; ++slot) {
            const std::uint32_t child = node.child[slot];
            const Bounds box = block ? grown(face_box(faces_[child]), margin) : boxes_[child];
            for (int axis = 0; axis < 3; ++axis) {
                node.lo[axis][slot] = box.lo[axis];
                node.hi[axis][slot] = box.hi[axis];
            }
            all = hull(all, box);
        }
        boxes_[index] = all;
    });
}

void BoxTree::refit(std::span<const glm::vec4> positions, BoxMargin margin, ThreadPool& pool)
{
    refit_nodes(pool, margin, [&](const glm::uvec3& face) { return corner_box(face, positions); });
}

void BoxTree::refit_swept(std::span<const glm::vec4> positions_t0, std::span<const glm::vec4> positions_t1,
                          BoxMargin margin, ThreadPool& pool)
{
    refit_nodes(pool, margin, [&](const glm::uvec3& face) {
        return hull(corner_box(face, positions_t0), corner_box(face, positions_t1));
    });
}

}  // namespace nuno
