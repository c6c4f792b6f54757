// nuno: the commands, and the one place where errors end.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/compare_command.h"
#include "app/list_commands.h"
#include "app/render_command.h"
#include "app/view_command.h"
#include "core/error.h"
#include "core/version.h"

namespace {

int run(int argc, char** argv)
{
    CLI::App program("nuno: cloth in real time on OpenGL 4.3, in a window and without one", "nuno");
    program.set_version_flag("--version", fmt::format("nuno {} ({})", nuno::kVersion, nuno::kCommit));
    program.require_subcommand(1);
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return fmt::format("nuno: {}; `nuno --help` and `nuno COMMAND --help` list what is possible\n", error.what());
    });
    int status = 0;

    nuno::ViewFlags view;
    CLI::App* view_command = program.add_subcommand("view", "Open the window on a scene");
    nuno::add_view_flags(*view_command, view);
    view_command->callback([&] { status = nuno::run_view(view); });

    nuno::RenderFlags render;
    CLI::App* render_command = program.add_subcommand("render", "Write frames of a scene without a display");
    nuno::add_render_flags(*render_command, render);
    render_command->callback([&] { status = nuno::run_render(render); });

    nuno::CompareFlags compare;
    CLI::App* compare_command = program.add_subcommand("compare", "Compare CPU and GPU: times and agreement");
    nuno::add_compare_flags(*compare_command, compare);
    compare_command->callback([&] { status = nuno::run_compare(compare); });

    program.add_subcommand("scenes", "List the scenes")->callback([&] { status = nuno::list_scenes(); });
    bool markdown = false;
    CLI::App* params_command = program.add_subcommand("params", "List the parameters: default, range, unit");
    params_command->add_flag("--markdown", markdown, "As docs/parameters.md");
    params_command->callback([&] { status = nuno::list_params(markdown); });

    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(nuno::ExitCode::bad_input);
    }
    return status;
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const nuno::Error& error) {
        fmt::print(stderr, "nuno: {}\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "nuno: there is not enough memory; choose a smaller resolution or size\n");
        return static_cast<int>(nuno::ExitCode::bad_input);
    }
}
