// Tree and boxes of a query, and what is kept of it.
#include "collision/element_query.h"

#include <glm/geometric.hpp>

#include "core/task_share.h"

namespace nuno {
namespace {

// Of the mean length of edges at rest, the largest margin of a query: beyond, lists grow too long.
constexpr float kMostMargin = 0.1f;

float mean_length(std::span<const glm::uvec2> edges, std::span<const glm::vec3> rest_positions)
{
    double sum = 0;
    for (const glm::uvec2& ends : edges) sum += double(glm::distance(rest_positions[ends.x], rest_positions[ends.y]));
    return edges.empty() ? 0.0f : static_cast<float>(sum / double(edges.size()));
}

}  // namespace

ElementQuery::ElementQuery(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                           std::span<const Sheet> sheets, ElementKinds kinds)
    : kinds_(kinds),
      elements_(faces, static_cast<std::uint32_t>(rest_positions.size()), kinds),
      near_(elements_.near_pairs()),
      tree_(rest_positions, faces, sheets),
      most_margin_(kMostMargin * mean_length(elements_.edges(), rest_positions))
{
}

KeptPairs& ElementQuery::kept_for(const TreeSettings& settings)
{
    if (!all_kept_[kept_last_].are_like(settings)) kept_last_ = 1 - kept_last_;
    return all_kept_[kept_last_];
}

int ElementQuery::begin(const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    KeptPairs& kept = kept_for(settings);
    if (kept.hold(poses, settings, pool)) {
        ++queries_skipped_;
        from_kept_ = true;
        if (!kept.pairs.empty()) swept_.set(poses, settings.distance, pool);
        return kept_tasks();
    }
    TreeSettings with_margin = settings;
    with_margin.margin = kept.margin_for(settings, most_margin_);
    kept.begin(poses, with_margin);
    from_kept_ = false;
    tree_.refit(poses, with_margin, pool);
    tree_.query(pool);
    if (!tree_.is_proven_apart()) {
        swept_.set(poses, settings.distance + with_margin.margin, pool);
        swept_.set_faces(elements_.faces(), pool);
    }
    if (with_margin.margin == 0) return static_cast<int>(near_tasks() + tree_.pairs().size());
    keep_pairs(kept, pool);
    swept_.set_distance(settings.distance);
    return kept_tasks();
}

// All that may meet at the distance with the margin.
void ElementQuery::keep_pairs(KeptPairs& kept, ThreadPool& pool)
{
    kept.near_culled = near_pairs_culled();
    const std::size_t tasks = near_tasks() + tree_.pairs().size();
    kept_of_task_.resize(std::max(kept_of_task_.size(), tasks));
    share_tasks(pool, static_cast<int>(tasks), [&](int task, int) {
        std::vector<ElementPair>& pairs = kept_of_task_[static_cast<std::size_t>(task)];
        pairs.clear();
        run(task, [&](const ElementPair& pair) { pairs.push_back(pair); });
    });
    for (std::size_t task = 0; task < tasks; ++task)
        kept.pairs.insert(kept.pairs.end(), kept_of_task_[task].begin(), kept_of_task_[task].end());
    from_kept_ = true;
}

// Without a branch on what is not to be foreseen: which vertices a face owns, and which of them may meet the other.
std::size_t ElementQuery::find_vertex_faces(std::span<const FacePair> faces, std::span<ElementPair> found) const
{
    struct Candidate
    {
        std::uint32_t vertex, face;
    };
    std::array<Candidate, 6 * kFacePairs + 1> candidates;
    std::size_t candidate_count = 0, count = 0;
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        for (const std::uint32_t v : elements_.owned(from).vertices) {
            candidates[candidate_count] = {v, to};
            candidate_count += v != FaceElements::kNone;
        }
    };
    for (const FacePair pair : faces) {
        add(pair.a, pair.b);
        add(pair.b, pair.a);
    }
    const bool is_swept = swept_.is_swept();
    for (std::size_t k = 0; k < candidate_count; ++k) {
        const auto [v, face] = candidates[k];
        const glm::uvec3& corners = elements_.faces()[face];
        found[count] = {PairKind::vertex_face, {v, corners.x, corners.y, corners.z}, face};
        count += is_swept ? swept_.may_meet(swept_.vertex(v), swept_.face(face)) : swept_.is_near(v, swept_.face(face));
    }
    return count;
}

std::uint64_t ElementQuery::near_pairs_culled() const
{
    if (from_kept_) return all_kept_[kept_last_].near_culled;
    if (tree_.is_proven_apart()) return near_.pairs.size();
    std::uint64_t count = 0;
    for (std::uint32_t face = 0; face < elements_.faces().size(); ++face)
        if (tree_.is_apart_from_neighbours(face)) count += near_.of(face).size();
    return count;
}

void ElementQuery::carry(Archive& archive)
{
    for (KeptPairs& kept : all_kept_) kept.carry(archive);
    archive.value(kept_last_);
    if (kept_last_ >= all_kept_.size()) kept_last_ = 0;
}

}  // namespace nuno
