// Includes and defines of shaders; GLSL 4.3 itself has no #include.
#include "gl/shader_source.h"

#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "core/error.h"
#include "core/files.h"

namespace nuno {
namespace {

constexpr std::string_view kVersionLine = "#version 430 core";
constexpr int kDeepest = 16;

struct Expansion
{
    std::span<const GeneratedInclude> generated;
    ShaderSource source;
};

std::string display_name(std::string_view path) { return "shaders/" + std::string(path); }

// The path that a line `#include "path"` names; empty for any other line. Error where the line cannot be read.
std::string included_path(std::string_view line, std::string_view where)
{
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || line.substr(start, 8) != "#include") return {};
    const std::size_t open = line.find('"', start);
    const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
    if (close == std::string_view::npos || close == open + 1)
        throw Error(fmt::format("{}: cannot read '{}'; write #include \"shared/file.h\"", where, line));
    return std::string(line.substr(open + 1, close - open - 1));
}

std::string_view next_line(std::string_view& rest)
{
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void append_text(Expansion& expansion, std::string_view text, const std::string& name, int first_line, int depth);

void append_include(Expansion& expansion, std::string path, const std::string& where, int depth)
{
    if (depth > kDeepest)
        throw Error(fmt::format("{}: includes nest more than {} deep; does a file include itself?", where, kDeepest));
    for (const GeneratedInclude& include : expansion.generated)
        if (include.name == path) return append_text(expansion, include.text, "generated " + path, 1, depth);
    if (path.starts_with("shaders/")) path.erase(0, 8);
    const std::filesystem::path full = root_directory() / "shaders" / path;
    std::error_code status;
    if (!std::filesystem::is_regular_file(full, status))
        throw Error(fmt::format("{}: includes \"{}\", but there is no file {}; give a path relative to shaders/", where,
                                path, full.string()));
    append_text(expansion, read_text(full), display_name(path), 1, depth);
}

// Appends `text`, whose first line is line `first_line` of the file `name`.
void append_text(Expansion& expansion, std::string_view text, const std::string& name, int first_line, int depth)
{
    const std::size_t number = expansion.source.files.size();
    expansion.source.files.push_back(name);
    expansion.source.text += fmt::format("#line {} {}\n", first_line, number);
    int line_number = first_line;
    for (std::string_view rest = text; !rest.empty(); ++line_number) {
        const std::string_view line = next_line(rest);
        const std::string where = fmt::format("{}:{}", name, line_number);
        const std::string path = included_path(line, where);
        if (path.empty()) {
            expansion.source.text.append(line).push_back('\n');
        } else {
            append_include(expansion, path, where, depth + 1);
            expansion.source.text += fmt::format("#line {} {}\n", line_number + 1, number);
        }
    }
}

}  // namespace

ShaderSource expand_shader(std::string_view file, std::span<const Define> defines,
                           std::span<const GeneratedInclude> generated)
{
    const std::string text = read_text(root_directory() / "shaders" / file);
    std::string_view rest = text;
    const std::string_view first = next_line(rest);
    if (first != kVersionLine)
        throw Error(fmt::format("{}:1: begins with '{}'; the first line must be '{}'", display_name(file), first,
                                kVersionLine));
    Expansion expansion{generated, {fmt::format("{}\n", kVersionLine), {}}};
    for (const Define& define : defines)
        expansion.source.text += fmt::format("#define {} {}\n", define.name, define.value);
    append_text(expansion, rest, display_name(file), 2, 0);
    return std::move(expansion.source);
}

std::string name_files(const ShaderSource& source, std::string_view log)
{
    // Mesa writes 0:12(5): error, NVIDIA 0(12) : error, others ERROR: 0:12: and the like.
    static const std::regex place(R"(^((?:ERROR|WARNING): )?(\d+)(?::(\d+)|\((\d+)\)))");
    std::string named;
    for (std::string_view rest = log; !rest.empty();) {
        const std::string line(next_line(rest));
        std::smatch match;
        const bool found = std::regex_search(line, match, place);
        const std::size_t file = found ? std::stoul(match[2].str()) : source.files.size();
        if (found && file < source.files.size()) {
            const std::string number = match[3].matched ? match[3].str() : match[4].str();
            named += fmt::format("{}:{}{}\n", source.files[file], number, match.suffix().str());
        } else if (!line.empty()) {
            named += line + '\n';
        }
    }
    if (named.ends_with('\n')) named.pop_back();
    return named;
}

}  // namespace nuno
