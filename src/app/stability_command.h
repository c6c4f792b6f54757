// `nuno stability`: where each method is stable, measured and predicted, and the extremes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/sweep_flags.h"

namespace nuno {

struct StabilityFlags
{
    CommonFlags common;
    std::vector<std::string> scenes;  // none: seed
    SweepFlags sweep{.out = "nuno-stability"};
    bool coarse = false;
};

void add_stability_flags(CLI::App& command, StabilityFlags& flags);

// 1 where a limit is not as predicted, or an extreme did not end as expected.
int run_stability(const StabilityFlags& flags);

}  // namespace nuno
