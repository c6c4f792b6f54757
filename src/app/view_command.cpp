// `nuno view`.
#include "app/view_command.h"

#include "app/viewer.h"
#include "core/files.h"

namespace nuno {

void add_view_flags(CLI::App& command, ViewFlags& flags)
{
    command.add_option("scene", flags.common.scene, "A scene of `nuno scenes`, or the path of a .toml file")
        ->capture_default_str();
    add_common_flags(command, flags.common);
    command.add_option("--size", flags.size, "Size of the window, WxH");
    add_promise_flags(command, flags.promise);
    command.add_flag("--paused", flags.paused, "Start at rest");
    command.add_flag("--log-actions", flags.log_actions, "Tell every action and the place of every control on stderr");
}

int run_view(const ViewFlags& flags)
{
    // A scene loaded later keeps what the command line set.
    const auto load = [&flags](const std::string& name_or_path) {
        SceneRun run = prepare_run(flags.common, name_or_path);
        apply_size(flags.size, run.view);
        return ViewerScene{std::move(run.scene), run.params, run.view};
    };
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    ViewerOptions options;
    options.promise = promised_goal(flags.promise, flags.common);
    options.quiet = flags.common.quiet;
    options.hash = flags.common.hash;
    options.start = load(flags.common.scene);
    options.load = load;
    options.width = options.start.view.width;
    options.height = options.start.view.height;
    options.paused = flags.paused;
    options.log_actions = flags.log_actions;
    options.json = flags.common.json;
    return run_viewer(options);
}

}  // namespace nuno
