// Reading and writing parameter blocks by name.
#include "core/params.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "core/error.h"
#include "core/text.h"

namespace nuno {
namespace {

std::string range_error(const ParamInfo& info, std::string_view given, std::string_view where)
{
    return fmt::format("{}: {} = {} is not possible; give {}", where, info.name, given, param_range_text(info));
}

std::string type_word(const ParamInfo& info)
{
    switch (info.type) {
    case ParamType::real: return "number";
    case ParamType::integer: return "whole number";
    case ParamType::boolean: return "true or false";
    case ParamType::choice: return "one of " + join_choices(info.choices);
    }
    return {};
}

}  // namespace

const ParamInfo* find_param(ParamTable table, std::string_view name)
{
    for (const ParamInfo& info : table)
        if (info.name == name) return &info;
    return nullptr;
}

double param_value(const ParamInfo& info, const void* block)
{
    const char* field = static_cast<const char*>(block) + info.offset;
    if (info.type == ParamType::real) {
        float value;
        std::memcpy(&value, field, sizeof value);
        return value;
    }
    std::int32_t value;
    std::memcpy(&value, field, sizeof value);
    return value;
}

std::string param_text(const ParamInfo& info, double value)
{
    switch (info.type) {
    case ParamType::real: return fmt::format("{}", static_cast<float>(value));
    case ParamType::integer: return fmt::format("{}", static_cast<std::int64_t>(value));
    case ParamType::boolean: return value != 0 ? "true" : "false";
    case ParamType::choice: return std::string(info.choices[static_cast<std::size_t>(value)]);
    }
    return {};
}

void set_param(const ParamInfo& info, void* block, double value, std::string_view where)
{
    const bool whole = info.type == ParamType::real || value == std::floor(value);
    // Compared as the float that is stored, so that a bound written in decimal accepts itself.
    const bool in_range = static_cast<float>(value) >= static_cast<float>(info.min) &&
                          static_cast<float>(value) <= static_cast<float>(info.max);
    if (!std::isfinite(value) || !whole || !in_range) throw Error(range_error(info, fmt::format("{}", value), where));
    char* field = static_cast<char*>(block) + info.offset;
    if (info.type == ParamType::real) {
        const float stored = static_cast<float>(value);
        std::memcpy(field, &stored, sizeof stored);
    } else {
        const auto stored = static_cast<std::int32_t>(value);
        std::memcpy(field, &stored, sizeof stored);
    }
    if (info.on_set) info.on_set(block);
}

void set_param_text(const ParamInfo& info, void* block, std::string_view text, std::string_view where)
{
    if (info.type == ParamType::choice) {
        for (std::size_t i = 0; i < info.choices.size(); ++i)
            if (info.choices[i] == text) return set_param(info, block, static_cast<double>(i), where);
        throw Error(fmt::format("{}: {} = {} is unknown; the nearest is {}; give {}", where, info.name, text,
                                nearest_name(text, info.choices), type_word(info)));
    }
    if (info.type == ParamType::boolean && (text == "true" || text == "false"))
        return set_param(info, block, text == "true" ? 1 : 0, where);
    const std::optional<double> value = parse_number(text);
    if (!value) throw Error(range_error(info, fmt::format("'{}'", text), where));
    set_param(info, block, *value, where);
}

void throw_unknown_param(std::string_view name, std::span<const ParamTable> tables, std::string_view where)
{
    std::vector<std::string_view> names;
    for (const ParamTable& table : tables)
        for (const ParamInfo& info : table) names.push_back(info.name);
    const std::string_view nearest = nearest_name(name, names);
    std::string range;
    for (const ParamTable& table : tables)
        if (const ParamInfo* info = find_param(table, nearest)) range = param_range_text(*info);
    throw Error(fmt::format("{}: no parameter is called {}; the nearest is {} ({}); `nuno params` lists all", where,
                            name, nearest, range));
}

std::string glsl_fields(ParamTable table)
{
    std::string fields;
    for (const ParamInfo& info : table)
        fields += fmt::format("    {} {};\n", info.type == ParamType::real ? "float" : "int", info.name);
    return fields;
}

std::string param_range_text(const ParamInfo& info)
{
    if (info.type == ParamType::boolean || info.type == ParamType::choice)
        return fmt::format("{}, default {}", type_word(info), param_text(info, info.default_value));
    return fmt::format("a {} from {} to {}{}{}, default {}", type_word(info), param_text(info, info.min),
                       param_text(info, info.max), info.unit.empty() ? "" : " ", info.unit,
                       param_text(info, info.default_value));
}

std::string param_docs(ParamTable table)
{
    std::string docs;
    std::string_view group;
    for (const ParamInfo& info : table) {
        if (info.group != group) {
            group = info.group;
            docs += fmt::format("\n### {}\n\n| name | default | range | unit | what it does |\n|---|---|---|---|---|\n",
                                group);
        }
        const std::string range = info.type == ParamType::boolean || info.type == ParamType::choice
                                      ? type_word(info)
                                      : param_text(info, info.min) + " .. " + param_text(info, info.max);
        docs += fmt::format("| `{}` | {} | {} | {} | {} |\n", info.name, param_text(info, info.default_value), range,
                            info.unit, info.help);
    }
    return docs;
}

}  // namespace nuno
