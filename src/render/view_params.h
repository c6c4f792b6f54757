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
    phong
};
enum class Background : std::int32_t
{
    studio,
    daylight,
    night
};

std::span<const std::string_view> choice_names(Look);
std::span<const std::string_view> choice_names(Background);

struct ViewParams
{
#define NUNO_FLOAT(name, value, min, max, unit, group, help) float name = value;
#define NUNO_INT(name, value, min, max, unit, group, help) std::int32_t name = value;
#define NUNO_BOOL(name, value, group, help) std::int32_t name = value;
#define NUNO_CHOICE(Type, name, value, group, help) Type name = Type::value;
#include "render/view_params.def"
#undef NUNO_FLOAT
#undef NUNO_INT
#undef NUNO_BOOL
#undef NUNO_CHOICE
};

ParamTable view_param_table();

}  // namespace nuno
