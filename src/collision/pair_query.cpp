// Splitting of a query into tasks.
#include "collision/pair_query.h"

namespace nuno {
namespace {

// Tasks of a large mesh, at least. They differ in length, so there are many more than threads.
constexpr std::size_t kTaskCount = 64;

}  // namespace

// A small mesh is one task. For a large one the query goes down level by level until there are enough pairs of nodes,
// each a task; task 0 keeps what was counted on the way.
int PairQuery::begin(const BoxTree& tree, Culling culling)
{
    tree_ = &tree;
    culling_ = culling;
    if (tasks_.empty()) tasks_.emplace_back();
    for (Task& task : tasks_) {
        task.blocks.open.clear();
        task.blocks.found.clear();
        task.blocks.pairs_culled = task.blocks.visits = 0;
        task.hit_count = task.pair_count = 0;
    }
    TreeQuery& front = tasks_[0].blocks;
    front.open.push_back(tree.root());
    if (!tree.is_large()) return 1;

    std::vector<NodePair> level;
    while (!front.open.empty() && front.open.size() < kTaskCount) {
        level.swap(front.open);
        front.open.clear();
        for (const NodePair pair : level) tree.visit(pair, front, culling);
    }
    level.swap(front.open);
    front.open.clear();
    if (tasks_.size() <= level.size()) tasks_.resize(level.size() + 1);
    for (std::size_t i = 0; i < level.size(); ++i) tasks_[i + 1].blocks.open.push_back(level[i]);
    return static_cast<int>(level.size()) + 1;
}

// Without branches, as find_hits.
void PairQuery::expand_hits(Task& task) const
{
    if (task.pairs.size() < 4 * task.hit_count) task.pairs.resize(8 * task.hit_count);
    for (const Hit hit : std::span(task.hits).first(task.hit_count)) {
        const BoxTree::Node& block = tree_->node(hit.block);
        for (int slot = 0; slot < 4; ++slot) {
            const std::uint32_t face = block.child[slot];
            const glm::uvec3 corners = tree_->faces()[face == BoxTree::kNoChild ? 0 : face];
            const bool is_corner = (hit.vertex == corners.x) | (hit.vertex == corners.y) | (hit.vertex == corners.z);
            task.pairs[task.pair_count] = {hit.vertex, face};
            task.pair_count += (hit.faces >> slot & 1u) & static_cast<unsigned>(!is_corner);
        }
    }
}

PairCounts PairQuery::counts() const
{
    PairCounts sum;
    for (const Task& task : tasks_) {
        sum.pairs_tested += task.pair_count;
        sum.pairs_culled += task.blocks.pairs_culled;
        sum.visits += task.blocks.visits;
    }
    return sum;
}

}  // namespace nuno
