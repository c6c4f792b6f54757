// `nuno compare`: the CPU against the GPU.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line.h"

namespace nuno {

struct CompareFlags
{
    CommonFlags common;
    std::vector<std::string> scenes;  // none: all
    std::string out = "nuno-compare";
    bool all = false;                  // every method of both backends
    std::vector<std::string> methods;  // these; none and not `all`: the scene's own
    std::vector<int> sizes;            // vertices along the longer side; none: the usual ones
};

void add_compare_flags(CLI::App& command, CompareFlags& flags);

// 1 where the backends do not agree as far as they must.
int run_compare(const CompareFlags& flags);

}  // namespace nuno
