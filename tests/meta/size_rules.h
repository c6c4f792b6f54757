// Limits on the size of files and functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nuno::meta {

inline constexpr int kMaxHeaderLines = 160;
inline constexpr int kMaxSourceLines = 400;
inline constexpr int kMaxFunctionLines = 60;

struct FunctionSize
{
    int line;   // of the opening brace, from 1
    int count;  // lines between the braces
};

// Functions of a text laid out by the project's clang-format: an opening brace alone on its line that is not a type's.
std::vector<FunctionSize> function_sizes(std::string_view text);

}  // namespace nuno::meta
