// The table of view parameters.
#include "render/view_params.h"

namespace nuno {
namespace {

constexpr std::string_view kLooks[] = {"gouraud", "phong", "cloth"};
constexpr std::string_view kBackgrounds[] = {"studio", "daylight", "night"};
constexpr std::string_view kHeats[] = {"none", "strain", "speed", "culled", "asleep"};

}  // namespace

std::span<const std::string_view> choice_names(Look) { return kLooks; }
std::span<const std::string_view> choice_names(Background) { return kBackgrounds; }
std::span<const std::string_view> choice_names(Heat) { return kHeats; }

ParamTable view_param_table()
{
    static const ParamInfo table[] = {
#define NUNO_PARAM_BLOCK ViewParams
#include "core/param_rows.inc"
#include "render/view_params.def"
#include "core/param_rows_end.inc"
    };
    return table;
}

}  // namespace nuno
