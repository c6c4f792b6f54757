// Files of continuous queries: a line `id kind x0 .. x23` each (docs/ccd.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision/ccd/four_points.h"

namespace nuno {

struct FileQuery
{
    std::string id;
    PairKind kind;
    FourPoints t0, t1;
};

// Numbers are decimal, with or without exponent, or hexadecimal as 0x1.8p-3. Empty lines, lines that start with # and
// carriage returns at the end are passed over. Throws Error with file and line where a line is anything else.
std::vector<FileQuery> read_query_file(const std::filesystem::path& path);

}  // namespace nuno
