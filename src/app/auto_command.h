// `nuno auto`, and the same choice for other commands.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/command_line.h"
#include "study/auto_choice.h"

namespace nuno {

struct AutoFlags
{
    CommonFlags common;
    std::optional<double> error_percent, budget_ms;
    bool forget = false;
};

void add_auto_flags(CLI::App& command, AutoFlags& flags);
int run_auto(const AutoFlags& flags);

// Measures and chooses for a scene; what was measured before on this machine is remembered, in $XDG_CACHE_HOME/nuno or
// ~/.cache/nuno. `forget`: measures all anew.
AutoChoice choose_for(const SceneRun& run, const AutoGoal& goal, bool quiet, bool forget);

}  // namespace nuno
