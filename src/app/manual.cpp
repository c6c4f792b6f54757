// The man page of nuno.
#include "app/manual.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "core/version.h"
#include "model/sim_params.h"
#include "render/view_params.h"

namespace nuno {
namespace {

using Row = std::pair<std::string_view, std::string_view>;

constexpr Row kExitCodes[] = {
    {"0", "done"},
    {"1", "a check failed, or a promise was not kept"},
    {"2", "the input was wrong, or there is no OpenGL 4.3; the message says what would be right"},
    {"3", "the numbers went bad: a vertex is no longer finite, or beyond 1e6 m or m/s"},
    {"130", "interrupted; what was written so far is whole"},
};

constexpr Row kEnvironment[] = {
    {"NUNO_ROOT", "the folder that holds assets and shaders"},
    {"XDG_CACHE_HOME", "where measurements of nuno auto are remembered; else ~/.cache"},
    {"LIBGL_ALWAYS_SOFTWARE", "1: Mesa's software renderer even where there is a graphics card"},
};

// Text as man(7) wants it: no character acts as a command.
std::string plain(std::string_view text)
{
    std::string out;
    if (!text.empty() && (text[0] == '.' || text[0] == '\'')) out += "\\&";
    for (const char letter : text) {
        if (letter == '\\')
            out += "\\e";
        else if (letter == '-')
            out += "\\-";
        else
            out += letter;
    }
    return out;
}

std::string item(std::string_view tag, std::string_view text)
{
    return fmt::format(".TP\n.B {}\n{}\n", plain(tag), plain(text));
}

// "--set NAME=VALUE", "scene"
std::string tag_of(const CLI::Option& option)
{
    std::string tag = option.get_name(option.get_positional());
    if (option.get_items_expected_max() > 0 && !option.get_positional() && !option.get_type_name().empty())
        tag += " " + option.get_type_name();
    return tag;
}

std::string command_page(const CLI::App& command)
{
    std::string page =
        fmt::format(".SS {}\n{}.\n", plain("nuno " + command.get_name()), plain(command.get_description()));
    for (const CLI::Option* option : command.get_options())
        if (option->get_name() != "--help") page += item(tag_of(*option), option->get_description());
    return page;
}

std::string param_page(ParamTable table)
{
    std::string page;
    for (const ParamInfo& info : table)
        page += item(info.name, fmt::format("{}. {}", param_range_text(info), info.help));
    return page;
}

}  // namespace

std::string help_footer()
{
    std::string text = "Exit codes:\n";
    for (const auto& [code, meaning] : kExitCodes) text += fmt::format("  {:<26}{}\n", code, meaning);
    text += "\nEnvironment:\n";
    for (const auto& [name, meaning] : kEnvironment) text += fmt::format("  {:<26}{}\n", name, meaning);
    return text;
}

std::string manual_page(const CLI::App& program)
{
    std::string page = fmt::format(".TH NUNO 1 \"\" \"nuno {}\" \"User Commands\"\n", kVersion);
    page += ".SH NAME\nnuno \\- simulate and draw cloth in real time\n";
    page += ".SH SYNOPSIS\n.B nuno\n.I COMMAND\n.RI [ SCENE ]\n.RI [ FLAGS ]\n";
    page += fmt::format(".SH DESCRIPTION\n{}.\n", plain(program.get_description()));
    page += "SCENE is a name that\n.B nuno scenes\nlists, or the path of a .toml file.\n.SH COMMANDS\n";
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        page += command_page(*command);
    page +=
        ".SH PARAMETERS\nEach is a key of a scene file, a slider of the window, and set by\n.B \\-\\-set NAME=VALUE\n";
    page += param_page(sim_param_table()) + param_page(view_param_table());
    page += ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : kExitCodes) page += item(code, meaning);
    page += ".SH ENVIRONMENT\n";
    for (const auto& [name, meaning] : kEnvironment) page += item(name, meaning);
    return page;
}

}  // namespace nuno
