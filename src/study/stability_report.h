// A stability study as tables, data and a page to read.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/stability_extremes.h"
#include "study/stability_map.h"

namespace nuno {

// One scene: its maps, its extremes, and what of them was measured.
struct StabilityScene
{
    std::unique_ptr<StabilityMaps> maps;
    std::vector<ExtremeCase> extremes;
    std::map<std::string, nlohmann::ordered_json> results;  // by the ids of maps and extremes
    const std::string& name() const { return maps->name(); }
};

// Whether measured limits are as predicted, and extremes ended as expected. False where one is not; unknown where none
// is against it but some are missing.
std::optional<bool> holds(const StabilityScene& scene);

std::string stability_table(const StabilityScene& scene);  // for people, a line a map
std::string stability_csv(const std::vector<StabilityScene>& scenes);
nlohmann::ordered_json stability_json(const std::vector<StabilityScene>& scenes);
// Draws the maps into the directory; false where gnuplot is missing or fails.
bool draw_stability(const StabilityScene& scene, const std::filesystem::path& directory);
// The page, with the pictures of the directory in it.
std::string stability_page(const std::vector<StabilityScene>& scenes, const SweepState& sweep,
                           const std::filesystem::path& directory);

}  // namespace nuno
