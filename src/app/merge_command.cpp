// `nuno merge`.
#include "app/merge_command.h"

#include <fmt/format.h>

#include "app/stability_command.h"
#include "app/sweep_scenes.h"
#include "app/trade_command.h"
#include "core/error.h"

namespace nuno {
namespace {

constexpr std::size_t kMostNamed = 8;

}  // namespace

void add_merge_flags(CLI::App& command, MergeFlags& flags)
{
    command.add_option("directories", flags.directories, "Directories of the parts of one sweep")->required();
    command.add_option("--out", flags.out, "Directory for the whole")->required();
    command.add_flag("--quiet", flags.quiet, "No remarks; what is missing is still told");
}

int run_merge(const MergeFlags& flags)
{
    StoredPoints all = joined_points({flags.directories.begin(), flags.directories.end()});
    const std::string study = all.header.value("study", "?");
    if (study != "trade" && study != "stability")
        throw Error(
            fmt::format("{}: its points are of `nuno {}`, which is not to be joined; give parts of `nuno "
                        "trade` or `nuno stability`",
                        flags.directories.front(), study));
    require_this_version(all.header);
    PointStore store(flags.out, all.header);
    store.add_missing(all.results);
    all.results = store.results();
    bool holds = true;
    const SweepState state = study == "trade" ? report_trade(all, flags.out, flags.quiet)
                                              : report_stability(all, flags.out, flags.quiet, holds);
    if (!state.missing.empty())
        fmt::print(stderr, "merge: {}; the same sweep with --out {} and no --shard measures them\n",
                   missing_text(state, kMostNamed), flags.out);
    return static_cast<int>(holds && state.missing.empty() ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace nuno
