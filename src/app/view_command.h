// `nuno view`: the window.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command_line.h"

namespace nuno {

struct ViewFlags
{
    CommonFlags common;
    std::string size;
    bool paused = false, log_actions = false;
};

void add_view_flags(CLI::App& command, ViewFlags& flags);
int run_view(const ViewFlags& flags);

}  // namespace nuno
