// Reading a TOML table key by key.
#include "scene/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"

namespace nuno {
namespace {

std::string scalar_text(const toml::node& node)
{
    if (const auto s = node.value_exact<std::string>()) return *s;
    if (const auto b = node.value_exact<bool>()) return *b ? "true" : "false";
    if (const auto i = node.value_exact<std::int64_t>()) return fmt::format("{}", *i);
    if (const auto d = node.value_exact<double>()) return fmt::format("{}", *d);
    return {};
}

}  // namespace

std::string TomlTable::where(std::string_view key) const
{
    const toml::node* node = key.empty() ? &table_ : table_.get(key);
    return fmt::format("{}:{}", file_, node ? node->source().begin.line : table_.source().begin.line);
}

void TomlTable::fail(std::string_view key, std::string_view expected) const
{
    const toml::node* node = table_.get(key);
    const std::string given = node ? scalar_text(*node) : std::string();
    throw Error(fmt::format("{}: {}{}{} must be {}", where(key), key, given.empty() ? "" : " = ", given, expected));
}

const toml::node* TomlTable::find(std::string_view key)
{
    known_.push_back(key);
    return table_.get(key);
}

std::string TomlTable::text(std::string_view key, std::string_view fallback)
{
    const toml::node* node = find(key);
    if (!node) return std::string(fallback);
    const auto value = node->value_exact<std::string>();
    if (!value) fail(key, "a text in quotes");
    return *value;
}

double TomlTable::number(std::string_view key, double fallback)
{
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || std::isnan(*value)) fail(key, "a number");
    return *value;
}

int TomlTable::whole(std::string_view key, int fallback)
{
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto value = node->value_exact<std::int64_t>();
    if (!value || *value < 0 || *value > 1000000000) fail(key, "a whole number from 0 to 1000000000");
    return static_cast<int>(*value);
}

glm::vec3 TomlTable::vector(std::string_view key, glm::vec3 fallback)
{
    const toml::node* node = find(key);
    if (!node) return fallback;
    const toml::array* array = node->as_array();
    if (!array || array->size() != 3) fail(key, "three numbers, [x, y, z]");
    glm::vec3 value;
    for (int k = 0; k < 3; ++k) {
        const toml::node& component = *array->get(static_cast<std::size_t>(k));
        const auto number = component.is_number() ? component.value<double>() : std::nullopt;
        if (!number || !std::isfinite(*number) || std::abs(*number) > 1e6)
            fail(key, "three finite numbers up to 1e6, [x, y, z]");
        value[k] = static_cast<float>(*number);
    }
    return value;
}

bool TomlTable::flag(std::string_view key, bool fallback)
{
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto value = node->value_exact<bool>();
    if (!value) fail(key, "true or false");
    return *value;
}

const toml::table* TomlTable::table(std::string_view key)
{
    const toml::node* node = find(key);
    if (node && !node->is_table()) fail(key, "a table");
    return node ? node->as_table() : nullptr;
}

const toml::array* TomlTable::array(std::string_view key)
{
    const toml::node* node = find(key);
    if (node && !node->is_array()) fail(key, "a list in brackets");
    return node ? node->as_array() : nullptr;
}

void TomlTable::for_each_table(std::string_view key, const std::function<void(TomlTable)>& read)
{
    if (table_[key].is_table()) fail(key, fmt::format("written as [[{}]], for there may be several", key));
    const toml::array* list = array(key);
    if (!list) return;
    for (const toml::node& node : *list) {
        if (!node.is_table()) fail(key, fmt::format("written as [[{}]]", key));
        read(TomlTable(*node.as_table(), file_));
    }
}

void TomlTable::read_params(ParamTable table, void* block)
{
    for (const auto& [key, node] : table_)
        if (!find_param(table, key.str())) throw_unknown_param(key.str(), std::span(&table, 1), where(key.str()));
    // In the order of the parameters, whatever that of the file: some set others that come after them.
    for (const ParamInfo& info : table) {
        const auto found = table_.find(info.name);
        if (found == table_.end()) continue;
        const toml::node& node = found->second;
        const std::string at = where(info.name);
        known_.push_back(info.name);
        const bool wants_text = info.type == ParamType::choice, wants_bool = info.type == ParamType::boolean;
        if (wants_text ? !node.is_string() : wants_bool ? !node.is_boolean() : !node.is_number())
            throw Error(fmt::format("{}: {} must be {}", at, info.name, param_range_text(info)));
        if (node.is_number())
            set_param(info, block, *node.value<double>(), at);
        else
            set_param_text(info, block, scalar_text(node), at);
    }
}

std::vector<TomlTable::Entry> TomlTable::entries()
{
    std::vector<Entry> all;
    for (const auto& [key, node] : table_) {
        if (!node.is_value()) fail(key.str(), "a number, true, false or a text");
        all.push_back({std::string(key.str()), scalar_text(node), where(key.str()), node.is_string()});
    }
    return all;
}

void TomlTable::finish() const
{
    for (const auto& [key, node] : table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        throw Error(fmt::format("{}: unknown key {}; the nearest is {}; possible are {}", where(key.str()), key.str(),
                                nearest_name(key.str(), known_), join_choices(known_)));
    }
}

}  // namespace nuno
