// `nuno manual` and `nuno completion`: made from the flags and parameters that --help and `nuno params` print.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace nuno {

// Exit codes and environment: the end of `nuno --help`, and of the man page.
std::string help_footer();

// The man page nuno(1), in the language of man(7).
std::string manual_page(const CLI::App& program);

// A script for bash that completes commands, flags, scenes, parameters and their choices.
std::string bash_completion(const CLI::App& program);

}  // namespace nuno
