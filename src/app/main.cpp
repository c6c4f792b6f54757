// nuno: the commands, and the one place where errors end.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "app/auto_command.h"
#include "app/compare_command.h"
#include "app/explain_command.h"
#include "app/list_commands.h"
#include "app/manual.h"
#include "app/merge_command.h"
#include "app/render_command.h"
#include "app/stability_command.h"
#include "app/trade_command.h"
#include "app/view_command.h"
#include "core/error.h"
#include "core/text.h"
#include "core/version.h"

namespace {

// What is wrong with the words, and the nearest command where the first one is none.
std::string usage_message(const CLI::App& program, int argc, char** argv, const CLI::Error& error)
{
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view word = argc > 1 ? argv[1] : "";
    if (word.empty()) return fmt::format("nuno: a command is missing; give {}\n", nuno::join_choices(views));
    if (word[0] != '-' && std::find(views.begin(), views.end(), word) == views.end())
        return fmt::format("nuno: {} is no command; the nearest is {}; possible are {}\n", word,
                           nuno::nearest_name(word, views), nuno::join_choices(views));
    return fmt::format("nuno: {}; `nuno --help` and `nuno COMMAND --help` list what is possible\n", error.what());
}

template <class Flags>
struct CommandFunctions
{
    void (*add_flags)(CLI::App&, Flags&);
    int (*run)(const Flags&);
};

// A command with flags of its own; its exit code goes to `status`.
template <class Flags>
void add_command(CLI::App& program, const char* name, const char* help, CommandFunctions<Flags> functions, int& status)
{
    const auto flags = std::make_shared<Flags>();
    CLI::App* command = program.add_subcommand(name, help);
    functions.add_flags(*command, *flags);
    command->callback([flags, functions, &status] { status = functions.run(*flags); });
}

int run(int argc, char** argv)
{
    CLI::App program("nuno: cloth in real time on OpenGL 4.3, in a window and without one", "nuno");
    program.set_version_flag("--version", fmt::format("nuno {} ({})", nuno::kVersion, nuno::kCommit));
    program.require_subcommand(1);
    program.failure_message(
        [&](const CLI::App*, const CLI::Error& error) { return usage_message(program, argc, argv, error); });
    int status = 0;

    using namespace nuno;
    add_command<ViewFlags>(program, "view", "Open the window on a scene", {add_view_flags, run_view}, status);
    add_command<RenderFlags>(program, "render", "Write frames of a scene without a display",
                             {add_render_flags, run_render}, status);
    add_command<CompareFlags>(program, "compare", "Compare CPU and GPU: times and agreement",
                              {add_compare_flags, run_compare}, status);
    add_command<AutoFlags>(program, "auto", "Find the cheapest setting that keeps a promise",
                           {add_auto_flags, run_auto}, status);
    add_command<ExplainFlags>(program, "explain", "Say what a scene needs, and what each part costs",
                              {add_explain_flags, run_explain}, status);
    add_command<TradeFlags>(program, "trade", "Measure speed against accuracy, and what to pick",
                            {add_trade_flags, run_trade}, status);
    add_command<MergeFlags>(program, "merge", "Join the parts of a sweep", {add_merge_flags, run_merge}, status);
    add_command<StabilityFlags>(program, "stability", "Map where each method is stable, and try the extremes",
                                {add_stability_flags, run_stability}, status);
    program.add_subcommand("scenes", "List the scenes")->callback([&] { status = nuno::list_scenes(); });
    bool markdown = false;
    CLI::App* params_command = program.add_subcommand("params", "List the parameters: default, range, unit");
    params_command->add_flag("--markdown", markdown, "As docs/parameters.md");
    params_command->callback([&] { status = nuno::list_params(markdown); });
    program.add_subcommand("manual", "Print the man page")->callback([&] { fmt::print("{}", manual_page(program)); });
    program.add_subcommand("completion", "Print a script that completes words in bash")->callback([&] {
        fmt::print("{}", bash_completion(program));
    });
    program.footer(help_footer());

    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(nuno::ExitCode::bad_input);
    }
    return status;
}

}  // namespace

// fmt throws where stderr is closed or full, which must not hide the exit code.
int say_and_exit(const std::string& message, nuno::ExitCode code)
{
    std::fputs(("nuno: " + message + "\n").c_str(), stderr);
    return static_cast<int>(code);
}

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const nuno::Error& error) {
        return say_and_exit(error.what(), error.code());
    } catch (const std::bad_alloc&) {
        return say_and_exit("there is not enough memory; choose a smaller resolution or size",
                            nuno::ExitCode::bad_input);
    } catch (const std::exception& error) {
        return say_and_exit(std::string("the system refused: ") + error.what(), nuno::ExitCode::bad_input);
    }
}
