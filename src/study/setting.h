// Settings: parameters by name and value, as --set takes them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "model/sim_params.h"

namespace nuno {

using Setting = std::vector<std::pair<std::string, std::string>>;

// "method=xpbd substeps=8", each word with `prefix` before it.
std::string setting_text(const Setting& setting, std::string_view prefix = "");
nlohmann::ordered_json setting_json(const Setting& setting);
// Error where a name or value is wrong.
SimParams with_setting(SimParams params, const Setting& setting);

}  // namespace nuno
