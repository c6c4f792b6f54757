// The self-query of the tree of faces, as tasks for several threads.
#include <algorithm>
#include <cassert>
#include <utility>

#include "collision/tree/face_tree.h"
#include "core/task_share.h"

namespace nuno {
namespace {

// The levels from the top down to one of at most so many nodes are opened by the caller alone; then there are tasks.
constexpr std::size_t kTopNodes = 256;
// Tasks differ in length, so there are many more than threads.
constexpr std::size_t kTasks = 64;
constexpr std::size_t kLeastPairs = 16, kLeastNodes = 8;

std::size_t ceil_div(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

QueryFrame FaceTree::query_frame() const
{
    QueryFrame query{};
    query.box = frame_;
    query.cells = layout_.cells.data();
    for (std::size_t level = 0; level < layout_.levels.size(); ++level)
        query.levels[level] = layout_.levels[level].data();
    query.proofs = settings_.culling == Culling::sound && !proofs_.empty() ? proof_levels_.data() : nullptr;
    query.windows = settings_.culling == Culling::sound && charts_ ? charts_->levels() : nullptr;
    query.masks_neighbours = masks_neighbours();
    query.compares_vertices = !layout_.mesh_nodes.empty() || !query.masks_neighbours;
    return query;
}

// Whether the culling says that nothing below a node touches anything else below it.
bool FaceTree::skips_self(int level, std::uint32_t node) const
{
    if (settings_.culling == Culling::seed) return seed_flags_.skips(level, node);
    if (settings_.culling != Culling::sound) return false;
    // A node of level 0 has no proof of its own.
    if (level == 0 && layout_.levels.size() == 1) return false;
    const TreeNode& square =
        level == 0 ? layout_.levels[1][node / 4] : layout_.levels[static_cast<std::size_t>(level)][node];
    if (square.grid >= kNoGrid) return charts_ && charts_->holds_node(std::max(level, 1), level == 0 ? node / 4 : node);
    const ProofLevel& proof = proof_levels_[square.grid * kMostLevels + static_cast<std::uint32_t>(std::max(level, 1))];
    return proof.flags[square.y * proof.width + square.x] & 1;
}

// The seed's rule speaks of whole nodes, so with it neighbours are met in the tree.
bool FaceTree::masks_neighbours() const { return settings_.culling != Culling::seed; }

// From the open pairs of a level, and its nodes with themselves, to the open pairs of the level below.
void FaceTree::open_children(int level)
{
    const std::vector<TreeNode>& nodes = layout_.levels[static_cast<std::size_t>(level)];
    const std::size_t most = 16 * (open_first_.size() + nodes.size()) + 32;
    if (next_first_.size() < most) {
        next_first_.resize(most);
        next_second_.resize(most);
    }
    std::size_t count = 0;
    const bool masks = level == 1 && masks_neighbours();
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        if (masks && nodes[n].meets_neighbours == 0) continue;
        const int pairs = kernels_->visit_self(nodes[n], n, next_first_.data() + count, next_second_.data() + count);
        if (pairs > 0 && !skips_self(level, n)) count += static_cast<std::size_t>(pairs);
    }
    for (std::size_t k = 0; k < open_first_.size(); ++k)
        count +=
            static_cast<std::size_t>(kernels_->visit_pair(nodes.data(), open_first_[k], open_second_[k], masks,
                                                          next_first_.data() + count, next_second_.data() + count));
    visits_ += nodes.size() + open_first_.size();
    open_first_.assign(next_first_.begin(), next_first_.begin() + static_cast<std::ptrdiff_t>(count));
    open_second_.assign(next_second_.begin(), next_second_.begin() + static_cast<std::ptrdiff_t>(count));
}

// Pairs of different nodes below each of these nodes of a level.
void FaceTree::visit_below(const QueryFrame& frame, int level, NodeRun nodes, Worker& worker, Task& task)
{
    constexpr std::uint32_t chunk = QueryScratch::kVisits;
    std::uint32_t first[QueryScratch::kRoom], second[QueryScratch::kRoom];
    // Cells of one node of a regular grid are neighbours, and so are the four nodes below one.
    const bool masks = level <= 1 && frame.masks_neighbours;
    for (std::uint32_t begin = nodes.begin; begin < nodes.end; begin += chunk) {
        int count = 0;
        for (std::uint32_t n = begin; n < std::min(begin + chunk, nodes.end); ++n) {
            const TreeNode& node = frame.levels[static_cast<std::size_t>(level)][n];
            if (masks && node.meets_neighbours == 0) continue;
            // Nodes that fill a grid up to fours have no place in it, and no pairs.
            const int pairs = kernels_->visit_self(node, n, first + count, second + count);
            if (pairs > 0 && !skips_self(level, n)) count += pairs;
        }
        kernels_->visit(frame, level - 1, {first, second, count}, worker.query, task.found);
    }
}

// How the work below a level is cut into tasks: first the open pairs of nodes, then the nodes with themselves, then
// what the bands have left. A property of the boxes, not of the threads.
FaceTree::TaskPlan FaceTree::plan_tasks(int level) const
{
    TaskPlan plan;
    plan.level = level;
    plan.node_count = layout_.levels[static_cast<std::size_t>(level)].size();
    plan.pairs_each = std::max(kLeastPairs, ceil_div(open_first_.size(), kTasks));
    plan.nodes_each = std::max(kLeastNodes, ceil_div(plan.node_count, kTasks));
    plan.pair_tasks = ceil_div(open_first_.size(), plan.pairs_each);
    plan.node_tasks = ceil_div(plan.node_count, plan.nodes_each);
    plan.task_count = plan.pair_tasks + plan.node_tasks + neighbours_.size();
    return plan;
}

void FaceTree::run_task(const QueryFrame& frame, const TaskPlan& plan, std::size_t number, Worker& worker, Task& task)
{
    const auto visit = [&](int level, const std::uint32_t* first, const std::uint32_t* second, std::size_t count) {
        kernels_->visit(frame, level, {first, second, static_cast<int>(count)}, worker.query, task.found);
    };
    if (number < plan.pair_tasks) {
        const std::size_t begin = number * plan.pairs_each;
        const std::size_t count = std::min(plan.pairs_each, open_first_.size() - begin);
        return visit(plan.level, &open_first_[begin], &open_second_[begin], count);
    }
    number -= plan.pair_tasks;
    if (number >= plan.node_tasks) {
        const NodePairs& nodes = neighbours_[number - plan.node_tasks].nodes;
        return visit(0, nodes.first(), nodes.second(), nodes.count());
    }
    std::size_t begin = number * plan.nodes_each, end = std::min(begin + plan.nodes_each, plan.node_count);
    for (int level = plan.level; level >= 0; --level, begin *= 4, end *= 4) {
        const std::size_t size = layout_.levels[static_cast<std::size_t>(level)].size();
        const NodeRun nodes{static_cast<std::uint32_t>(std::min(begin, size)),
                            static_cast<std::uint32_t>(std::min(end, size))};
        visit_below(frame, level, nodes, worker, task);
    }
}

void FaceTree::query(ThreadPool& pool)
{
    parts_.clear();
    visits_ = 0;
    if (proven_apart_) return;
    int level = 0;
    while (layout_.levels[static_cast<std::size_t>(level)].size() > kTopNodes) ++level;
    open_first_.clear();
    open_second_.clear();
    for (int l = static_cast<int>(layout_.levels.size()) - 1; l > level; --l) open_children(l);

    const TaskPlan plan = plan_tasks(level);
    if (tasks_.size() < plan.task_count) tasks_.resize(plan.task_count);
    const QueryFrame frame = query_frame();
    share(pool, static_cast<int>(plan.task_count), [&](int number, int thread) {
        Worker& worker = workers_[static_cast<std::size_t>(thread)];
        Task task = std::move(tasks_[static_cast<std::size_t>(number)]);
        task.found.clear();
        worker.query.visits = 0;
        run_task(frame, plan, static_cast<std::size_t>(number), worker, task);
        task.visits = worker.query.visits;
        tasks_[static_cast<std::size_t>(number)] = std::move(task);
    });

    for (const BandFound& found : neighbours_) parts_.push_back(found.faces.pairs());
    for (std::size_t t = 0; t < plan.task_count; ++t) {
        parts_.push_back(tasks_[t].found.pairs());
        visits_ += tasks_[t].visits;
    }
}

std::uint64_t FaceTree::pair_count() const
{
    std::uint64_t count = 0;
    for (const std::span<const FacePair> part : parts_) count += part.size();
    return count;
}

}  // namespace nuno
