// A block of parameters as its table declares it: one row a field, serving flags, scene files, sliders, GLSL, docs and
// reports.
//
// A block is a plain struct of 4-byte scalars made from a .def file of rows (src/model/sim_params.def). Each row is one
// of
//   NUNO_FLOAT(name, default, min, max, unit, group, help)
//   NUNO_INT(name, default, min, max, unit, group, help)
//   NUNO_BOOL(name, default, group, help)                     stored as 0 or 1
//   NUNO_CHOICE(Type, name, default, group, help)             stored as the index of a name of choice_names(Type{})
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace nuno {

enum class ParamType
{
    real,
    integer,
    boolean,
    choice
};

struct ParamInfo
{
    ParamType type;
    std::string_view name;
    double default_value;  // of a choice: its index
    double min, max;
    std::string_view unit;   // SI, empty where the number has none
    std::string_view group;  // heading it stands under in the panel and the docs
    std::string_view help;   // one sentence
    std::span<const std::string_view> choices;
    std::size_t offset;                     // bytes from the start of the block
    void (*on_set)(void* block) = nullptr;  // called once a value is stored: sets the fields that follow from this one
};

using ParamTable = std::span<const ParamInfo>;

const ParamInfo* find_param(ParamTable table, std::string_view name);

// The value of one field of `block`; a choice as its index.
double param_value(const ParamInfo& info, const void* block);
std::string param_text(const ParamInfo& info, double value);

// Stores a value. Error, prefixed by `where` (a flag, a file and line), where it is not finite, out of range or not
// whole.
void set_param(const ParamInfo& info, void* block, double value, std::string_view where);

// Stores a value given as text: a number, true/false, or the name of a choice.
void set_param_text(const ParamInfo& info, void* block, std::string_view text, std::string_view where);

// The error for a name that no table has; names the nearest one.
[[noreturn]] void throw_unknown_param(std::string_view name, std::span<const ParamTable> tables,
                                      std::string_view where);

// GLSL fields of a std140 block, one line each, in table order: float or int.
std::string glsl_fields(ParamTable table);

// A section of docs/parameters.md: one Markdown table a group.
std::string param_docs(ParamTable table);

// "float, 0.1 to 10000 N/m, default 40".
std::string param_range_text(const ParamInfo& info);

}  // namespace nuno
