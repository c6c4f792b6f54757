// `nuno auto`, and the same choice for `view` and `render`.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "app/command_line.h"
#include "study/promise_keeper.h"

namespace nuno {

// --error and --budget-ms; at most one of them.
struct PromiseFlags
{
    std::optional<double> error_percent, budget_ms;

    bool is_given() const { return error_percent || budget_ms; }
};

void add_promise_flags(CLI::App& command, PromiseFlags& flags);

// None where none is given. Error where it is no goal, or a setting that is chosen for it is set as well.
std::optional<AutoGoal> promised_goal(const PromiseFlags& flags, const CommonFlags& common);

// Sets what `nuno auto` chooses for the run, and tells it on stderr. What keeps the promise from then on, as the run goes
// on; none where none is given. Self-collision is left out only from a run of no more frames than were looked at.
std::shared_ptr<PromiseKeeper> apply_promise(const PromiseFlags& flags, const CommonFlags& common, SceneRun& run,
                                             int frames);

struct AutoFlags
{
    CommonFlags common;
    PromiseFlags promise;
    bool forget = false;
};

void add_auto_flags(CLI::App& command, AutoFlags& flags);
int run_auto(const AutoFlags& flags);

}  // namespace nuno
