// Runs nuno itself; what needs that waits for the program to be built.
#include "support/program_run.h"

namespace nuno {

ProgramResult run_program(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                          const ProgramLimits& limits)
{
    std::vector<std::string> all{NUNO_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    return run_words(all, environment, limits);
}

}  // namespace nuno
