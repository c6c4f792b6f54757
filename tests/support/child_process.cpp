// What a process that a test has forked becomes.
#include "support/child_process.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace nuno {

void become_program(const std::vector<std::string>& words, const std::vector<std::string>& environment)
{
    // The test may be killed for taking too long; what it started must end with it.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const std::string& setting : environment) {
        const std::size_t equals = setting.find('=');
        const std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
        if (value.empty())
            unsetenv(name.c_str());
        else
            setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

}  // namespace nuno
