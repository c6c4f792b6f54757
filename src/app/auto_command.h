// `nuno auto`, and the same choice for `view` and `render`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/command_line.h"

namespace nuno {

// --error and --budget-ms; at most one of them.
struct PromiseFlags
{
    std::optional<double> error_percent, budget_ms;

    bool is_given() const { return error_percent || budget_ms; }
};

void add_promise_flags(CLI::App& command, PromiseFlags& flags);

// Sets what `nuno auto` chooses for the run, and tells it on stderr. False where the promise cannot be kept.
bool apply_promise(const PromiseFlags& flags, SceneRun& run, bool quiet);

struct AutoFlags
{
    CommonFlags common;
    PromiseFlags promise;
    bool forget = false;
};

void add_auto_flags(CLI::App& command, AutoFlags& flags);
int run_auto(const AutoFlags& flags);

}  // namespace nuno
