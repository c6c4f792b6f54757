// Terms of xpbd.
#include "solver/xpbd/xpbd_terms.h"

#include <algorithm>

#include "solver/base/cloth_solver.h"

namespace nuno {

SubstepTimes::SubstepTimes(const SimParams& p)
    : h(substep_s(p)),
      step(static_cast<float>(double(h) * 2 / 3)),
      per_step(static_cast<float>(1.5 / double(h))),
      keep(static_cast<float>(1 / (1 + double(p.damping) / double(p.areal_density) * double(step))))
{
}

int sweep_pairs(const SimParams& params) { return std::max(params.iterations, 1); }

glm::vec3 common_acceleration(const SimParams& p, double time_s)
{
    return {p.gravity_x, p.gravity_y, p.gravity_z + wind_pressure(p, time_s) / p.areal_density};
}

formulas::Motion assumed_past(const SimParams& p, glm::vec3 x, glm::vec3 v)
{
    return formulas::assumed_last(formulas::motion(x, v), {p.gravity_x, p.gravity_y, p.gravity_z}, substep_s(p));
}

XpbdChanges xpbd_changes(const std::optional<SimParams>& before, const SimParams& now)
{
    const auto differs = [&](auto member) { return !before || (*before).*member != now.*member; };
    const bool times = differs(&SimParams::substeps) || differs(&SimParams::frame_rate);
    return {times, times || differs(&SimParams::iterations) || differs(&SimParams::strain_limit)};
}

}  // namespace nuno
