// `nuno merge`: joins the parts of a sweep.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace nuno {

struct MergeFlags
{
    std::vector<std::string> directories;
    std::string out;
    bool quiet = false;
};

void add_merge_flags(CLI::App& command, MergeFlags& flags);

// 1 where points are missing, or where the whole sweep would end with it.
int run_merge(const MergeFlags& flags);

}  // namespace nuno
