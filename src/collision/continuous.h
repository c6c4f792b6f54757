// Levels `speculative`, `continuous` and `guaranteed` (docs/collision.md): contacts found ahead of a pass for solvers
// to keep, and after it what the whole way of the cloth would run into.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/collision_counts.h"
#include "collision/element_query.h"
#include "collision/impact_search.h"
#include "collision/speculative.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

struct LayerSettings
{
    float thickness;                  // [m]
    float friction, static_friction;  // between layers
    bool guaranteed;                  // rolls back what rounds of impulses leave
    Culling culling = Culling::sound;
    // [ms] that the answer to the impacts of a pass may take before it goes the short way: everything that still meets
    // goes back to the start of the pass. The promise holds, results depend on the machine's speed. 0: no limit.
    float budget_ms = 0;
};

// The cloth over one pass.
struct LayerPass
{
    std::span<const glm::vec4> start;  // xyz [m], w inverse mass [1/kg]
    std::span<glm::vec4> end;          // where the solver took it; corrected
    std::span<glm::vec4> velocities;   // at the end, xyz [m/s]; corrected by what the ends are
    float duration;                    // [s]
};

class ContinuousCollision
{
  public:
    // `model` must outlive it.
    ContinuousCollision(const ClothModel& model, ThreadPool& pool);

    // The contacts that may come about within `duration` [s] from this state on, where vertices go on at these
    // velocities, in a fixed order; they last until the next call.
    const SpeculativeContacts& foresee(std::span<const glm::vec4> positions, std::span<const glm::vec4> velocities,
                                       float duration, const LayerSettings& settings);

    // Answers all impacts on the way of the pass: rounds of impulses, then, where guaranteed, rollback until none is
    // left. Start must be free of intersections for that to hold; pairs that touch there are let alone.
    CollisionCounts respond(const LayerPass& pass, const LayerSettings& settings);

    // What the last calls of both found; it lasts until the next ones. An impact that came back in a later round is
    // there again.
    std::span<const LayerContact> foreseen() const { return foreseen_.contacts; }
    std::span<const Impact> impacts() const { return impacts_; }

    // Writes what later queries take from earlier ones, or reads it.
    void carry(Archive& archive) { query_.carry(archive); }

  private:
    // Impacts among the pairs with a vertex that is marked, in a fixed order.
    std::vector<Impact> find_impacts(const LayerPass& pass, Culling culling, CollisionCounts& counts);
    // Rounds of impulses; false where impacts are left.
    bool push_apart(const LayerPass& pass, const LayerSettings& settings, const Stopwatch& watch,
                    CollisionCounts& counts);
    void roll_back_until_clean(const LayerPass& pass, const LayerSettings& settings, const Stopwatch& watch,
                               CollisionCounts& counts);
    void mark(const std::vector<Impact>& impacts);

    const ClothModel& model_;
    ThreadPool& pool_;
    ElementQuery query_;
    std::vector<std::uint32_t> sheet_numbers_;  // of every vertex
    SpeculativeContacts foreseen_;
    std::vector<SpeculativeContacts> foreseen_of_task_;
    std::vector<Impact> impacts_;  // of all rounds of the pass
    std::vector<glm::vec4> ways_;  // of every vertex in the pass
    std::vector<std::vector<Impact>> impacts_of_task_;
    std::vector<std::uint64_t> pairs_of_task_;
    std::vector<std::uint8_t> dirty_;  // of every vertex: its way has changed since it was last looked at
};

}  // namespace nuno
