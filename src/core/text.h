// Small text tools: the nearest known name for a misspelt one, numbers with nothing left over.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace nuno {

// The candidate with the least edit distance to `name`; empty where there is none at all.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

// The number that is the whole of `text`, in the C locale; none where anything is left over or nothing was read.
std::optional<double> parse_number(std::string_view text);

// "a, b or c".
std::string join_choices(std::span<const std::string_view> names);

}  // namespace nuno
