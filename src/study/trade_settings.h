// Which settings of a scene are tried against its reference.
#pragma once

#include <vector>

#include "model/body.h"
#include "model/cloth_model.h"
#include "study/setting.h"

namespace nuno {

// Methods with rising substeps, iterations and tethers, of all that can run this model.
std::vector<Setting> settings_in_time(const ClothModel& model, const Bodies& bodies, const SimParams& params);

// One of each method that can run it and holds with the substeps that nuno gives it.
std::vector<Setting> settings_by_method(const ClothModel& model, const Bodies& bodies, const SimParams& params);

}  // namespace nuno
