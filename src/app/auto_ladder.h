// The ladder of settings that a run can move on, measured for one scene on this machine and remembered.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "study/auto_choice.h"
#include "study/point_store.h"
#include "study/promise_keeper.h"

namespace nuno {

struct MeasuredLadder
{
    AutoGoal goal;                      // that it was measured for
    SimParams base;                     // the parameters without a rung's
    std::vector<Rung> rungs;            // by rising cost and falling error; empty where no setting ran to its end
    std::size_t chosen = 0;             // the rung for the goal
    bool is_kept = false;               // the goal; else the chosen one is the nearest to it
    int foretold_frames = 0;            // from when on a broken promise of an error is not held against a run; 0: never
    std::vector<std::string> given_up;  // by the chosen one, a sentence each

    // Of a ladder with rungs.
    PromiseKeeper keeper() const { return {goal, rungs, chosen, base, foretold_frames}; }
};

// The ladder around a choice, remembered in the store.
MeasuredLadder measure_ladder(SceneStudy& study, const SimParams& base, const AutoGoal& goal, const AutoChoice& choice,
                              PointStore& store, const SweepProgress& progress);

// What was measured before for this scene, these parameters and this goal, by this program on this machine; it only
// reads. None where nothing was, or it cannot be read.
std::optional<MeasuredLadder> remembered_ladder(const Scene& scene, const SimParams& base, const AutoGoal& goal);

}  // namespace nuno
