// The cheapest setting of a scene that keeps an error, or the most exact one within a budget, by measurement on this
// machine (docs/auto.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/promise_keeper.h"
#include "study/scene_study.h"
#include "study/setting.h"
#include "study/sweep.h"

namespace nuno {

// Error where a goal is none: zero, negative, both or neither given.
AutoGoal auto_goal(std::optional<double> error_percent, std::optional<double> budget_ms);

struct AutoChoice
{
    Setting set;                                          // empty where nothing that was tried ran to its end
    Setting rung;                                         // of these, the words of the ladder
    int substeps = 0;                                     // a frame, as used
    double error_share = 0;                               // measured over the horizon of the scene
    double ms_per_frame = 0;                              // measured, with self-collision
    bool is_kept = false;                                 // the goal; else this is the nearest to it
    SceneClass horizon;                                   // how far errors are measured
    CollisionLevel horizon_level = CollisionLevel::none;  // of self-collision while they are
    int frames_looked_at = 0;                             // for layers that meet
    int tried = 0, known = 0;                             // settings measured now, and before
    std::vector<std::string> given_up;                    // what it does without, a sentence each
};

// Settings are tried by rising cost until no cheaper one is left; what was measured before is in `store` and not
// measured again. `progress` is called before each; where it is false the search ends with what is known.
AutoChoice choose_setting(SceneStudy& study, const AutoGoal& goal, PointStore& store, const SweepProgress& progress);

// The settings that a run can move to from there: by rising cost and falling error, the chosen one among them, some more
// exact ones measured now where they were not. With `doubling_m` where the goal is an error. Empty where there was no
// choice.
std::vector<Rung> ladder_around(SceneStudy& study, const AutoGoal& goal, const AutoChoice& choice, PointStore& store,
                                const SweepProgress& progress);

}  // namespace nuno
