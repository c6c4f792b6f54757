// The table of presets.
#include "app/presets.h"

#include <string>

#include "core/params.h"

namespace nuno {
namespace {

using Setting = Preset::Setting;

constexpr Setting kCotton[] = {{"fabric", "cotton"}};
constexpr Setting kSilk[] = {{"fabric", "silk"}};
constexpr Setting kWool[] = {{"fabric", "wool"}};
constexpr Setting kDenim[] = {{"fabric", "denim"}};

constexpr Setting kCalm[] = {{"wind_strength", "0"}, {"wind_mean", "0"}, {"wind_x", "0"},
                             {"wind_y", "0"},        {"wind_z", "0"},    {"gust_speed", "0"}};
constexpr Setting kBreeze[] = {{"wind_model", "aero"}, {"wind_x", "0"},     {"wind_y", "0"},
                               {"wind_z", "3"},        {"gust_speed", "1"}, {"gust_size", "1"}};
constexpr Setting kGale[] = {{"wind_model", "aero"}, {"wind_x", "0"},     {"wind_y", "0"},
                             {"wind_z", "18"},       {"gust_speed", "4"}, {"gust_size", "2"}};
constexpr Setting kGusty[] = {{"wind_model", "aero"}, {"wind_x", "0"},     {"wind_y", "0"},
                              {"wind_z", "4"},        {"gust_speed", "6"}, {"gust_size", "0.5"}};

constexpr Setting kFast[] = {{"method", "xpbd"}, {"substeps", "10"},        {"iterations", "0"},
                             {"sweep", "auto"},  {"collision", "discrete"}, {"collision_passes", "0"}};
constexpr Setting kBalanced[] = {{"method", "auto"},           {"substeps", "0"},
                                 {"iterations", "0"},          {"sweep", "auto"},
                                 {"collision", "speculative"}, {"collision_passes", "0"}};
constexpr Setting kAccurate[] = {{"method", "xpbd"}, {"substeps", "60"},          {"iterations", "0"},
                                 {"sweep", "auto"},  {"collision", "continuous"}, {"collision_passes", "0"}};

constexpr Preset kPresets[] = {
    {PresetKind::fabric, "cotton", "Light woven cotton, as measured.", kCotton},
    {PresetKind::fabric, "silk", "Thin silk that folds finely, as measured.", kSilk},
    {PresetKind::fabric, "wool", "Soft wool, as measured.", kWool},
    {PresetKind::fabric, "denim", "Heavy, stiff denim, as measured.", kDenim},
    {PresetKind::wind, "calm", "Still air.", kCalm},
    {PresetKind::wind, "breeze", "3 m/s along z with small gusts: cloth sways.", kBreeze},
    {PresetKind::wind, "gale", "18 m/s along z with gusts: cloth stands in the wind.", kGale},
    {PresetKind::wind, "gusty", "4 m/s along z with small gusts of 6 m/s: cloth flutters.", kGusty},
    {PresetKind::quality, "fast", "10 substeps of xpbd, and layers looked at once a frame; threads give a little.",
     kFast},
    {PresetKind::quality, "balanced", "Method and substeps chosen for the cloth, and layers foreseen.", kBalanced},
    {PresetKind::quality, "accurate", "60 substeps of xpbd, and layers followed all the way; the slowest.", kAccurate},
};

}  // namespace

std::span<const Preset> preset_table() { return kPresets; }

SimParams with_preset(const Preset& preset, SimParams params)
{
    for (const Setting& setting : preset.settings)
        set_param_text(*find_param(sim_param_table(), setting.name), &params, setting.value, "preset");
    return params;
}

}  // namespace nuno
