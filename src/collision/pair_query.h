// Pairs of a vertex and a face whose boxes overlap, found by the tree, as tasks for several threads.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/box_tree.h"
#include "collision/vertex_face.h"

namespace nuno {

struct PairCounts
{
    std::uint64_t pairs_tested = 0;  // of a vertex and a face: their boxes overlap
    std::uint64_t pairs_culled = 0;  // inside the nodes skipped for their normals, a vertex's own faces included
    std::uint64_t visits = 0;        // of pairs of nodes
};

// Keeps its storage from one query to the next.
class PairQuery
{
  public:
    // Begins a query of `tree`, which must stay as it is until the last task is done; returns the number of tasks. What
    // the tasks are depends on the boxes alone: so the pairs of all, in order of tasks, do not depend on threads.
    int begin(const BoxTree& tree, Culling culling);

    // The pairs of one task, with box_of(vertex) the box of a vertex, in a fixed order, each once. A vertex is not
    // paired with a face that it is a corner of. They last until `begin`. Different tasks may run on different threads.
    template <class BoxOfVertex>
    std::span<const VertexFace> run(int task, const BoxOfVertex& box_of);

    // Over all tasks that have run.
    PairCounts counts() const;

  private:
    // A vertex whose box overlaps those of some faces of a block, one bit each.
    struct Hit
    {
        std::uint32_t vertex, block, faces;
    };
    // Storage only grows: the counts say how much of it is in use.
    struct Task
    {
        TreeQuery blocks;
        std::vector<Hit> hits;
        std::vector<VertexFace> pairs;
        std::size_t hit_count = 0, pair_count = 0;
    };
    template <class BoxOfVertex>
    void find_hits(std::uint32_t from, std::uint32_t to, const BoxOfVertex& box_of, Task& task) const;
    void expand_hits(Task& task) const;

    const BoxTree* tree_ = nullptr;
    Culling culling_ = Culling::none;
    std::vector<Task> tasks_;
};

template <class BoxOfVertex>
std::span<const VertexFace> PairQuery::run(int task, const BoxOfVertex& box_of)
{
    // On this thread's stack meanwhile, for the tasks of two threads may lie in one cache line.
    Task own = std::move(tasks_[task]);
    tree_->query(own.blocks, culling_);
    for (const NodePair pair : own.blocks.found) {
        find_hits(pair.a, pair.b, box_of, own);
        if (pair.a != pair.b) find_hits(pair.b, pair.a, box_of, own);
    }
    expand_hits(own);
    tasks_[task] = std::move(own);
    return std::span(tasks_[task].pairs).first(tasks_[task].pair_count);
}

// The vertices of block `from` against the faces of block `to`. Every vertex is written and only the hits are kept: a
// branch on them would be foreseen wrongly half the time.
template <class BoxOfVertex>
void PairQuery::find_hits(std::uint32_t from, std::uint32_t to, const BoxOfVertex& box_of, Task& task) const
{
    const std::span<const std::uint32_t> vertices = tree_->vertices(from);
    if (task.hits.size() < task.hit_count + vertices.size()) task.hits.resize(2 * (task.hit_count + vertices.size()));
    for (const std::uint32_t vertex : vertices) {
        const unsigned faces = overlapping_children(tree_->node(to), box_of(vertex));
        task.hits[task.hit_count] = {vertex, to, faces};
        task.hit_count += faces != 0;
    }
}

}  // namespace nuno
