// Self-collision of a cloth, stage by stage: what the rest of the program sees of this folder.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/box_tree.h"
#include "collision/contact.h"
#include "collision/discrete.h"
#include "core/thread_pool.h"
#include "model/sim_params.h"

namespace nuno {

// How contacts are looked for and answered in one pass.
struct CollisionSettings
{
    CollisionLevel level = CollisionLevel::discrete;
    Culling culling = Culling::none;
    ContactRange range;
};

CollisionSettings collision_settings(const SimParams& params);

// The cloth in one pass. Positions: xyz [m], w the inverse mass [1/kg], 0 where pinned.
struct CollisionStep
{
    std::span<const glm::vec4> positions_t0;  // at the pass before
    std::span<const glm::vec4> positions_t1;  // now
    std::span<glm::vec4> velocities;          // now, xyz [m/s]; corrected by `respond`
    float duration;                           // [s] from t0 to t1
};

// What a pass did, named as in the report.
struct CollisionCounts
{
    std::uint64_t pairs_tested = 0;  // of a vertex and a face, or two edges: their boxes overlap
    std::uint64_t pairs_culled = 0;  // inside the nodes that the culling skipped, a vertex's own faces included
    std::uint32_t contacts = 0;      // found, or foreseen
    std::uint32_t impacts = 0, zones = 0, rollbacks = 0, standstills = 0;  // of the continuous levels
    std::uint32_t unresolved = 0;  // pairs left by `continuous`, touching, or passed through, if that was counted
};

// A pass is refit, query, respond, in this order; each does nothing but at `discrete`. Results do not depend on
// the number of threads.
class SelfCollision
{
  public:
    // Rest positions [m] and faces of all sheets together; every vertex is a corner of a face.
    SelfCollision(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces, ThreadPool& pool);

    // Starts a pass with these settings: boxes around the cloth.
    void refit(const CollisionStep& step, const CollisionSettings& settings);
    // The contacts, in order of vertex and face; they last until the next pass.
    std::span<const Contact> query(const CollisionStep& step);
    // Corrects the velocities.
    void respond(const CollisionStep& step);

    // Counts what passed through from t0 to t1 into `unresolved`, at every level. Call it after `query`: it takes the
    // boxes for itself.
    void count_pass_through(const CollisionStep& step);

    // Of the pass so far.
    const CollisionCounts& counts() const { return counts_; }

  private:
    ThreadPool& pool_;
    BoxTree tree_;
    ContactSearch search_;
    CollisionSettings settings_;
    CollisionCounts counts_;
    std::span<const Contact> contacts_;
};

}  // namespace nuno
