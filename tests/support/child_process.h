// What a process that a test has forked becomes.
#pragma once

#include <string>
#include <vector>

namespace nuno {

// Applies NAME=VALUE settings (an empty VALUE removes NAME) and runs `words`, the program first, in place of this process.
// Exit code 127 where it cannot be run.
[[noreturn]] void become_program(const std::vector<std::string>& words, const std::vector<std::string>& environment);

}  // namespace nuno
