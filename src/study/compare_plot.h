// The comparison as pictures, drawn by gnuplot, and as a page to read.
#pragma once

#include <filesystem>
#include <vector>

#include "study/compare.h"

namespace nuno {

// Writes compare.dat and compare.gp to `directory`, and compare.svg and compare.png where gnuplot is installed.
// False where it is not, or fails.
bool plot_comparison(const std::vector<ComparePoint>& points, bool software_gl, const std::filesystem::path& directory);

// The same names, of many methods: the ratio of the times, a column a method and a point a scene and size.
bool plot_ratios(const std::vector<ComparePoint>& points, bool software_gl, const std::filesystem::path& directory);

// The whole comparison as a page that needs nothing beside it, with compare.svg of the directory in it. `left_out`:
// what was not run, and why.
std::string compare_page(const std::vector<ComparePoint>& points, const std::vector<std::string>& left_out,
                         const nlohmann::ordered_json& machine, const std::filesystem::path& directory);

}  // namespace nuno
