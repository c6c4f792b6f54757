// `nuno explain`.
#include "app/explain_command.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/interrupt.h"
#include "app/sweep_flags.h"
#include "core/error.h"
#include "core/files.h"
#include "study/explain.h"

namespace nuno {

void add_explain_flags(CLI::App& command, ExplainFlags& flags)
{
    command.add_option("scene", flags.common.scene, "Scene")->capture_default_str();
    add_common_flags(command, flags.common);
    command
        .add_option("--tolerance", flags.tolerance_percent,
                    "Change that does not matter, percent of the size of the cloth")
        ->capture_default_str();
}

int run_explain(const ExplainFlags& flags)
{
    if (!(flags.tolerance_percent > 0 && flags.tolerance_percent <= 100))
        throw Error(
            fmt::format("--tolerance {}: give percent of the size of the cloth, over 0 and up to 100, such as 1",
                        flags.tolerance_percent));
    SceneRun run = prepare_run(flags.common, flags.common.scene);
    if (!sets(flags.common, "threads")) run.params.threads = 1;
    if (!flags.common.json.empty()) check_can_write(flags.common.json);
    SceneStudy study(std::move(run.scene), run.params);
    const Explanation explanation =
        explain_scene(study, flags.tolerance_percent / 100, InterruptibleProgress("explain", flags.common.quiet));
    fmt::print("{}", explain_table(explanation));
    if (!flags.common.json.empty()) write_whole(flags.common.json, explain_json(explanation).dump(1) + "\n");
    return static_cast<int>(interrupted() ? ExitCode::interrupted : ExitCode::done);
}

}  // namespace nuno
