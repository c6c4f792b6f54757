// Levels `discrete` and `spheres`, stage by stage, and the count of what passed through, which every level can have.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/collision_counts.h"
#include "collision/contact.h"
#include "collision/discrete.h"
#include "collision/element_query.h"
#include "collision/spheres.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// How contacts are looked for and answered in one pass.
struct CollisionSettings
{
    CollisionLevel level = CollisionLevel::discrete;
    Culling culling = Culling::sound;
    ContactRange range;
    float friction = 0, static_friction = 0;  // between layers, at `spheres`
};

CollisionSettings collision_settings(const SimParams& params);

// Error where the level cannot keep its promise with the culling asked for.
void check_collision_settings(const SimParams& params);

// The cloth in one pass. Positions: xyz [m], w the inverse mass [1/kg], 0 where pinned.
struct CollisionStep
{
    std::span<const glm::vec4> positions_t0;  // at the pass before
    std::span<const glm::vec4> positions_t1;  // now
    std::span<glm::vec4> velocities;          // now, xyz [m/s]; corrected by `respond`
    float duration;                           // [s] from t0 to t1
};

// A pass is refit, query, respond, in this order; each does nothing but at `spheres` and `discrete`. Results do not
// depend on the number of threads.
class SelfCollision
{
  public:
    // Rest positions [m] and faces of all sheets together, which must outlive it; every vertex is a corner of a face.
    // Without sheets, all faces are one mesh.
    SelfCollision(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                  std::span<const Sheet> sheets, ThreadPool& pool);

    // Starts a pass with these settings: sorts vertices into cells, or makes the tree's boxes and finds faces whose
    // boxes overlap.
    void refit(const CollisionStep& step, const CollisionSettings& settings);
    // Finds contacts, or pairs of spheres, that the boxes or cells hold; whether there are any.
    bool query(const CollisionStep& step);
    // Corrects the velocities.
    void respond(const CollisionStep& step);

    // The contacts of the last query at `discrete`, in order of vertex and face; they last until the next pass.
    std::span<const Contact> contacts() const { return contacts_; }
    // The pairs of spheres of the last query at `spheres`, likewise.
    std::span<const VertexPair> sphere_pairs() const { return sphere_pairs_; }

    // Counts what passed through from t0 to t1 into `unresolved`, at every level. Call it after `query`: it takes the
    // tree for itself.
    void count_pass_through(const CollisionStep& step);

    // Of the pass so far.
    const CollisionCounts& counts() const { return counts_; }

    // Writes what later passes take from earlier ones, or reads it.
    void carry(Archive& archive);

  private:
    ElementQuery& tree();

    std::span<const glm::vec3> rest_positions_;
    std::span<const glm::uvec3> faces_;
    std::span<const Sheet> sheets_;
    ThreadPool& pool_;
    std::optional<ElementQuery> tree_;     // made where it is needed
    std::optional<SphereSearch> spheres_;  // likewise
    int task_count_ = 0;                   // of the tree's query
    ContactSearch search_;
    CollisionSettings settings_;
    CollisionCounts counts_;
    std::span<const Contact> contacts_;
    std::span<const VertexPair> sphere_pairs_;
};

}  // namespace nuno
