// `nuno trade` and `nuno merge`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/sweep_flags.h"

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

struct MergeFlags
{
    std::vector<std::string> directories;
    std::string out;
    bool quiet = false;
};

void add_merge_flags(CLI::App& command, MergeFlags& flags);
int run_merge(const MergeFlags& flags);

}  // namespace nuno
