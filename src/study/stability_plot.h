// A map of stability as a picture: a panel for each method.
#pragma once

#include <filesystem>

#include "study/stability_map.h"

namespace nuno {

// Draws directory/name.svg and .png: cells coloured by verdict, error and growth, predicted limits and measured ones
// over them. False where gnuplot is missing or fails.
bool plot_stability(const StabilityMaps& maps, MapKind kind,
                    const std::map<std::string, nlohmann::ordered_json>& results,
                    const std::filesystem::path& directory, const std::string& name);

}  // namespace nuno
