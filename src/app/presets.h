// Named sets of parameters, to begin from.
#pragma once

#include <span>
#include <string_view>

#include "model/sim_params.h"

namespace nuno {

enum class PresetKind
{
    fabric,
    wind,
    quality
};

struct Preset
{
    struct Setting
    {
        std::string_view name, value;  // as on the command line
    };
    PresetKind kind;
    std::string_view name;
    std::string_view help;  // one sentence
    std::span<const Setting> settings;
};

std::span<const Preset> preset_table();

// `params` with what the preset sets.
SimParams with_preset(const Preset& preset, SimParams params);

}  // namespace nuno
