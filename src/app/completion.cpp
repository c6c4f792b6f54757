// The completion of nuno in bash.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "app/manual.h"
#include "model/sim_params.h"
#include "render/view_params.h"

namespace nuno {
namespace {

// bash takes `=` for a word of its own, so a value of --set is its third word.
constexpr std::string_view kScript = R"(# Completion of nuno in bash, written by `nuno completion`.
_nuno_choices() {{
    case $1 in
{choices}    esac
}}

_nuno() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} flags= list=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W '{commands}' -- "$word")
        return
    fi
    case ${{COMP_WORDS[1]}} in
{flags}    esac
    if [[ $word == = || $before == = ]]; then
        local at=$((COMP_CWORD - 1))
        [[ $word == = ]] && word='' || at=$((COMP_CWORD - 2))
        list=$(_nuno_choices "${{COMP_WORDS[at]}}")
    elif [[ $before == --set ]]; then
        list='{params}'
        compopt -o nospace
    elif [[ $word == -* ]]; then
        list=$flags
    elif [[ $before == --* ]]; then
        list=$(_nuno_choices "${{before#--}}")
    else
        list=$(nuno scenes 2>/dev/null | cut -d ' ' -f 1)
    fi
    mapfile -t COMPREPLY < <(compgen -W "$list" -- "$word")
}}
complete -o default -F _nuno nuno
)";

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::string choices_of(ParamTable table)
{
    std::string lines;
    for (const ParamInfo& info : table)
        if (info.type == ParamType::choice)
            lines += fmt::format("        {}) echo '{}' ;;\n", info.name, fmt::join(info.choices, " "));
        else if (info.type == ParamType::boolean)
            lines += fmt::format("        {}) echo 'true false' ;;\n", info.name);
    return lines;
}

std::string flags_of(const CLI::App& command)
{
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_positional()) words.push_back(option->get_name());
    return fmt::format("        {}) flags='{}' ;;\n", command.get_name(), joined(words));
}

}  // namespace

std::string bash_completion(const CLI::App& program)
{
    std::vector<std::string> commands, params;
    std::string flags;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        commands.push_back(command->get_name());
        flags += flags_of(*command);
    }
    for (const ParamTable table : {sim_param_table(), view_param_table()})
        for (const ParamInfo& info : table) params.push_back(fmt::format("{}=", info.name));
    return fmt::format(
        fmt::runtime(kScript), fmt::arg("choices", choices_of(sim_param_table()) + choices_of(view_param_table())),
        fmt::arg("commands", joined(commands)), fmt::arg("flags", flags), fmt::arg("params", joined(params)));
}

}  // namespace nuno
