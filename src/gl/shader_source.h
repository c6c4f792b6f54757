// The text of a shader put together from the files under shaders/, before any driver sees it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nuno {

// `#define name value`, put right after the #version line.
struct Define
{
    std::string name, value;
};

// A text that `#include "name"` finds before any file, such as the fields of a parameter block.
struct GeneratedInclude
{
    std::string name, text;
};

struct ShaderSource
{
    std::string text;
    std::vector<std::string> files;  // by the number that #line gives them in `text`
};

// The file `shaders/<file>` with every line `#include "path"` replaced by that file, as often as it is written,
// whatever #if it stands in. A path is relative to shaders/, with or without that word in front.
// Error naming file and line where one cannot be read, where includes are nested more than 16 deep, or where the first
// line of `file` is not `#version 430 core`.
ShaderSource expand_shader(std::string_view file, std::span<const Define> defines = {},
                           std::span<const GeneratedInclude> generated = {});

// The driver's `log` with the name of the file in place of its number in front of each message.
std::string name_files(const ShaderSource& source, std::string_view log);

}  // namespace nuno
