// One pass of self-collision.
#include "collision/self_collision.h"

#include <cassert>

#include "collision/impulse.h"
#include "collision/pass_through.h"

namespace nuno {

CollisionSettings collision_settings(const SimParams& params)
{
    return {params.collision, params.culling, {params.thickness, params.edge_tolerance}};
}

SelfCollision::SelfCollision(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                             ThreadPool& pool)
    : pool_(pool), tree_(rest_positions, faces)
{
}

void SelfCollision::refit(const CollisionStep& step, const CollisionSettings& settings)
{
    settings_ = settings;
    counts_ = {};
    contacts_ = {};
    if (settings_.level != CollisionLevel::discrete) return;
    tree_.refit(step.positions_t1, contact_margin(settings_.range), pool_);
    if (settings_.culling == Culling::seed) tree_.bound_normals(step.positions_t1, pool_);
}

std::span<const Contact> SelfCollision::query(const CollisionStep& step)
{
    if (settings_.level != CollisionLevel::discrete) return {};
    contacts_ = search_.find(tree_, step.positions_t1, settings_.range, settings_.culling, pool_);
    const PairCounts counts = search_.counts();
    counts_.pairs_tested = counts.pairs_tested;
    counts_.pairs_culled = counts.pairs_culled;
    counts_.contacts = static_cast<std::uint32_t>(contacts_.size());
    return contacts_;
}

void SelfCollision::respond(const CollisionStep& step)
{
    apply_impulses(contacts_, tree_.faces(), step.positions_t1, step.velocities, settings_.range.thickness,
                   step.duration);
}

void SelfCollision::count_pass_through(const CollisionStep& step)
{
    const auto passed = find_pass_through(tree_, step.positions_t0, step.positions_t1, pool_);
    counts_.unresolved = static_cast<std::uint32_t>(passed.size());
}

}  // namespace nuno
