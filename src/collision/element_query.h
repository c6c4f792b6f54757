// All pairs of a vertex and a face, and of two edges, whose boxes overlap on a way; as tasks for several threads.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/box_tree.h"
#include "collision/face_elements.h"
#include "collision/vertex_boxes.h"
#include "core/thread_pool.h"

namespace nuno {

class ElementQuery
{
  public:
    // Rest positions [m] and faces of all sheets together.
    ElementQuery(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces);

    // Begins a query with boxes around the ways from t0 to t1 (xyz [m]), each vertex's grown by `growth` [m] on every
    // side; returns the number of tasks. What the tasks are does not depend on the number of threads.
    int begin(std::span<const glm::vec4> positions_t0, std::span<const glm::vec4> positions_t1, float growth,
              ThreadPool& pool);
    // Calls body(const ElementPair&) for the pairs of one task, in a fixed order; each pair is in one task, once.
    // Different tasks may run on different threads.
    template <class Body>
    void run(int task, const Body& body) const;

  private:
    static constexpr std::size_t kBlockPairs = 256, kNearPairs = 4096;  // of a task
    template <class Body>
    void run_blocks(NodePair blocks, const Body& body) const;

    FaceElements elements_;
    std::vector<ElementPair> near_;  // of faces that share a vertex
    BoxTree tree_;
    TreeQuery blocks_;
    VertexBoxes boxes_;
};

template <class Body>
void ElementQuery::run(int task, const Body& body) const
{
    const std::size_t near_tasks = (near_.size() + kNearPairs - 1) / kNearPairs;
    const auto number = static_cast<std::size_t>(task);
    if (number < near_tasks) {
        const std::size_t end = std::min(near_.size(), (number + 1) * kNearPairs);
        for (std::size_t i = number * kNearPairs; i < end; ++i)
            if (boxes_.overlap(near_[i])) body(near_[i]);
        return;
    }
    const std::size_t first = (number - near_tasks) * kBlockPairs;
    const std::size_t end = std::min(blocks_.found.size(), first + kBlockPairs);
    for (std::size_t i = first; i < end; ++i) run_blocks(blocks_.found[i], body);
}

template <class Body>
void ElementQuery::run_blocks(NodePair blocks, const Body& body) const
{
    const BoxTree::Node &a = tree_.node(blocks.a), &b = tree_.node(blocks.b);
    for (int i = 0; i < 4; ++i) {
        if (a.child[i] == BoxTree::kNoChild) continue;
        const auto lane = [&](const std::array<Float4, 3>& bounds, int axis) { return bounds[axis][i]; };
        const Bounds box{Float4{lane(a.lo, 0), lane(a.lo, 1), lane(a.lo, 2), 0},
                         Float4{lane(a.hi, 0), lane(a.hi, 1), lane(a.hi, 2), 0}};
        unsigned others = overlapping_children(b, box);
        if (blocks.a == blocks.b) others &= ~0u << (i + 1);
        for (; others != 0; others &= others - 1) {
            const std::uint32_t f = a.child[i], g = b.child[std::countr_zero(others)];
            if (g == BoxTree::kNoChild || elements_.share_vertex(f, g)) continue;
            elements_.for_pairs_of(f, g, [&](const ElementPair& pair) {
                if (boxes_.overlap(pair)) body(pair);
            });
        }
    }
}

}  // namespace nuno
