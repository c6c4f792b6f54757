// What xpbd makes of the parameters, whatever the order of its constraints and the backend.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "model/formulas.h"
#include "model/sim_params.h"

namespace nuno {

// Lengths of time of a substep (shaders/shared/xpbd.h).
struct SubstepTimes
{
    float h, step, per_step, keep;

    explicit SubstepTimes(const SimParams& params);
};

// How often the constraints are swept in a substep, each time there and back.
int sweep_pairs(const SimParams& params);

// Acceleration [m/s2] of every vertex at a time: gravity, and the wind's pressure on cloth in the plane x y.
glm::vec3 common_acceleration(const SimParams& params, double time_s);

// The motion before x, v of a vertex that has no past (assumed_last of shaders/shared/xpbd.h).
formulas::Motion assumed_past(const SimParams& params, glm::vec3 x, glm::vec3 v);

// What other parameters than before, if there were any, leave behind.
struct XpbdChanges
{
    bool times;   // the length of a substep: no past is known
    bool shares;  // of the constraints, weights and masses being the same
};
XpbdChanges xpbd_changes(const std::optional<SimParams>& before, const SimParams& now);

}  // namespace nuno
