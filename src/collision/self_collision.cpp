// One pass of self-collision at the levels below `speculative`.
#include "collision/self_collision.h"

#include "collision/impulse.h"
#include "collision/pass_through.h"
#include "core/error.h"

namespace nuno {

CollisionSettings collision_settings(const SimParams& params)
{
    return {params.collision,
            params.culling,
            {params.thickness, params.edge_tolerance},
            params.friction,
            params.static_friction};
}

void check_collision_settings(const SimParams& params)
{
    if (params.collision == CollisionLevel::guaranteed && params.culling == Culling::seed)
        throw Error(
            "culling: seed can lose contacts, so that collision guaranteed could not keep its promise; choose culling "
            "sound or none, or collision continuous");
}

SelfCollision::SelfCollision(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                             std::span<const Sheet> sheets, ThreadPool& pool)
    : rest_positions_(rest_positions), faces_(faces), sheets_(sheets), pool_(pool)
{
}

ElementQuery& SelfCollision::tree()
{
    if (!tree_) tree_.emplace(rest_positions_, faces_, sheets_, ElementKinds::vertex_face);
    return *tree_;
}

void SelfCollision::refit(const CollisionStep& step, const CollisionSettings& settings)
{
    settings_ = settings;
    counts_ = {};
    contacts_ = {};
    sphere_pairs_ = {};
    if (settings_.level == CollisionLevel::spheres) {
        if (!spheres_) spheres_.emplace(rest_positions_, sheets_);
        spheres_->sort(step.positions_t1, settings_.range.thickness);
    }
    if (settings_.level != CollisionLevel::discrete) return;
    const float distance = contact_reach(settings_.range, faces_, step.positions_t1);
    task_count_ = tree().begin({step.positions_t1, step.positions_t1}, {distance, settings_.culling}, pool_);
}

bool SelfCollision::query(const CollisionStep& step)
{
    if (settings_.level == CollisionLevel::spheres) {
        sphere_pairs_ = spheres_->find(pool_);
        counts_.pairs_tested = spheres_->pairs_tested();
        counts_.contacts = static_cast<std::uint32_t>(sphere_pairs_.size());
    }
    if (settings_.level == CollisionLevel::discrete) {
        contacts_ = search_.find(tree(), task_count_, step.positions_t1, settings_.range, pool_);
        counts_.pairs_tested = search_.pairs_tested();
        if (settings_.culling == Culling::sound) counts_.pairs_culled = tree().near_pairs_culled();
        counts_.contacts = static_cast<std::uint32_t>(contacts_.size());
    }
    return counts_.contacts > 0;
}

void SelfCollision::respond(const CollisionStep& step)
{
    if (settings_.level == CollisionLevel::spheres)
        push_spheres_apart(sphere_pairs_, {settings_.range.thickness, settings_.friction, settings_.static_friction},
                           {step.positions_t1, step.velocities, step.duration});
    if (settings_.level == CollisionLevel::discrete)
        apply_impulses(contacts_, faces_, step.positions_t1, step.velocities, settings_.range.thickness, step.duration);
}

void SelfCollision::count_pass_through(const CollisionStep& step)
{
    const auto passed = find_pass_through(tree(), step.positions_t0, step.positions_t1, pool_);
    counts_.unresolved = static_cast<std::uint32_t>(passed.size());
}

void SelfCollision::carry(Archive& archive)
{
    bool made = tree_.has_value();
    archive.value(made);
    if (made)
        tree().carry(archive);
    else
        tree_.reset();
}

}  // namespace nuno
