// A trade study as pictures and as a page to read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/sweep.h"
#include "study/trade_results.h"

namespace nuno {

// Draws directory/trade-NAME.svg and .png: error against cost of one scene, a curve a variant, the front over them.
// False where gnuplot is missing or fails, or where nothing was measured.
bool plot_trade(const TradeScene& scene, const std::filesystem::path& directory);

// The page, with the pictures of `directory` in it.
std::string trade_page(const std::vector<TradeScene>& scenes, const SweepState& sweep,
                       const std::filesystem::path& directory);

}  // namespace nuno
