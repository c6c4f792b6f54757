// Pictures by gnuplot, where it is installed.
#pragma once

#include <filesystem>
#include <string>

namespace nuno {

// For a text in single quotes of a script.
std::string gnuplot_quoted(std::string text);

// Draws directory/name.svg and name.png, `width` x `height` pixels, from a script that sets up and plots, run once
// for each; directory/name.gp keeps the whole script. False, with no picture left half-drawn, where gnuplot is missing
// or fails.
bool draw_with_gnuplot(const std::filesystem::path& directory, const std::string& name, const std::string& script,
                       int width = 1000, int height = 600);

}  // namespace nuno
