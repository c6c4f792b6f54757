// `nuno view`: the window.
#pragma once

#include <CLI/CLI.hpp>

#include "app/auto_command.h"
#include "app/command_line.h"

namespace nuno {

struct ViewFlags
{
    CommonFlags common;
    PromiseFlags promise;
    std::string size;
    bool paused = false, log_actions = false;
};

void add_view_flags(CLI::App& command, ViewFlags& flags);
int run_view(const ViewFlags& flags);

}  // namespace nuno
