// The floors of the architecture as a check on one #include at a time.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nuno::meta {

struct Include
{
    int line;  // from 1
    std::string path;
    bool angled;  // <path> rather than "path"
};

// Every #include of a C++ or GLSL text.
std::vector<Include> read_includes(std::string_view text);

// What is wrong with `include` in `file` (a path from the root, below src/ or shaders/); nothing where it keeps the
// rules: only the file's own folder or a lower floor, and each third-party library only in the folders meant for it.
std::optional<std::string> include_breach(std::string_view file, const Include& include);

}  // namespace nuno::meta
