// `nuno explain`.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command_line.h"

namespace nuno {

struct ExplainFlags
{
    CommonFlags common;
    double tolerance_percent = 1;
};

void add_explain_flags(CLI::App& command, ExplainFlags& flags);
int run_explain(const ExplainFlags& flags);

}  // namespace nuno
