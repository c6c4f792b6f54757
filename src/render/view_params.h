// The parameters of the picture: a struct made from the rows of view_params.def, and the table of those rows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/params.h"

namespace nuno {

enum class Look : std::int32_t
{
    gouraud,
    phong,
    cloth
};
enum class Background : std::int32_t
{
    studio,
    daylight,
    night
};
// What the cloth is coloured by in place of its texture.
enum class Heat : std::int32_t
{
    none,
    strain,
    speed,
    culled,
    asleep
};

std::span<const std::string_view> choice_names(Look);
std::span<const std::string_view> choice_names(Background);
std::span<const std::string_view> choice_names(Heat);

struct ViewParams
{
#include "core/param_fields.inc"
//
#include "render/view_params.def"
//
#include "core/param_rows_end.inc"
};

ParamTable view_param_table();

}  // namespace nuno
