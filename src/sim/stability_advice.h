// What a user is told about a substep that is too long.
#pragma once

#include <optional>
#include <string>

#include "model/stability.h"

namespace nuno {

// Before a run: nothing where the substep is within the stable one of cloth stretched by kStretchAllowedFor; else both,
// and the number of substeps that holds.
std::optional<std::string> stability_warning(const ClothModel& model, const SimParams& params);

// After a run that stayed finite: nothing where the substep is within the stable one of the cloth as it is now.
std::optional<std::string> present_warning(const ClothModel& model, const SimParams& params,
                                           const PresentStability& now);

// After one that did not.
std::string advice_after_blow_up(const ClothModel& model, const SimParams& params);

}  // namespace nuno
