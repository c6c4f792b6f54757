// The source tree as data for the meta tests. Paths are relative to its root, with forward slashes.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nuno::meta {

// Absolute path of the root of the source tree.
std::string root();

// Every file below `folder` whose name ends with one of `endings`, sorted; empty where the folder does not exist.
std::vector<std::string> files_under(std::string_view folder, std::initializer_list<std::string_view> endings);

// Files that git tracks, and new ones it would not ignore; nothing where git or its checkout is missing.
std::optional<std::vector<std::string>> tracked_files();

// The bytes of one file of the tree. Throws std::runtime_error where it cannot be read.
std::string read_file(std::string_view path);

std::vector<std::string> lines_of(std::string_view text);

struct CommandResult
{
    int exit_code;
    std::string output;  // stdout and stderr
};

// Runs a shell command in the root of the tree.
CommandResult run_command(const std::string& command);

}  // namespace nuno::meta
