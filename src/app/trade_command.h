// `nuno trade`: what accuracy costs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/sweep_flags.h"
#include "study/sweep.h"

namespace nuno {

struct TradeFlags
{
    CommonFlags common;
    std::vector<std::string> scenes;
    SweepFlags sweep{.out = "nuno-trade"};
    int repeats = 5;
};

void add_trade_flags(CLI::App& command, TradeFlags& flags);
int run_trade(const TradeFlags& flags);

// Writes data, pictures and the page of points that are there already; what the sweep came to.
SweepState report_trade(const StoredPoints& all, const std::filesystem::path& out, bool quiet);

}  // namespace nuno
