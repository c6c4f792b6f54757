// `nuno stability`: where each method is stable, measured and predicted, and the extremes.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/sweep_flags.h"
#include "study/sweep.h"

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

// Writes data, pictures and the page of points that are there already; `holds`: none of them is against what is expected.
SweepState report_stability(const StoredPoints& all, const std::filesystem::path& out, bool quiet, bool& holds);

}  // namespace nuno
