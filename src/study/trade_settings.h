// Which settings of a scene are tried against its reference.
#pragma once

#include <vector>

#include "model/body.h"
#include "model/cloth_model.h"
#include "solver/method_table.h"
#include "study/setting.h"

namespace nuno {

// Whether a method runs on the CPU and takes a scene's parameters, but for tethers and strain limits.
bool can_run(const MethodInfo& info, const SimParams& params);

// A method, without the tethers and strain limits that a scene asks for where it has none.
Setting of_method(const MethodInfo& info, const SimParams& params);

// Methods with rising substeps, iterations and tethers, of all that can run this model.
std::vector<Setting> settings_in_time(const ClothModel& model, const Bodies& bodies, const SimParams& params);

// One of each method that can run it and holds with the substeps that nuno gives it.
std::vector<Setting> settings_by_method(const ClothModel& model, const Bodies& bodies, const SimParams& params);

}  // namespace nuno
