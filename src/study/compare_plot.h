// The comparison as a picture, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <vector>

#include "study/compare.h"

namespace nuno {

// Writes compare.dat and compare.gp to `directory`, and compare.svg and compare.png where gnuplot is installed.
// False where it is not, or fails.
bool plot_comparison(const std::vector<ComparePoint>& points, bool software_gl, const std::filesystem::path& directory);

}  // namespace nuno
