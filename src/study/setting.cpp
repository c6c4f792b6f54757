// Settings as text and JSON.
#include "study/setting.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace nuno {

std::string setting_text(const Setting& setting, std::string_view prefix)
{
    std::string text;
    for (const auto& [name, value] : setting)
        text += fmt::format("{}{}{}={}", text.empty() ? "" : " ", prefix, name, value);
    return text;
}

nlohmann::ordered_json setting_json(const Setting& setting)
{
    nlohmann::ordered_json words;
    for (const auto& [name, value] : setting) words[name] = value;
    return words;
}

SimParams with_setting(SimParams params, const Setting& setting)
{
    for (const auto& [name, value] : setting) {
        const ParamInfo* info = find_param(sim_param_table(), name);
        if (info == nullptr) throw_unknown_param(name, std::vector{sim_param_table()}, "setting");
        set_param_text(*info, &params, value, "setting " + name);
    }
    return params;
}

}  // namespace nuno
