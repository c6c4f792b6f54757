// Runs a program as a user would.
#include "support/program_run.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "core/files.h"
#include "support/child_process.h"

namespace nuno {

namespace fs = std::filesystem;

namespace {

void limit_file_size(long bytes)
{
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes)};
    setrlimit(RLIMIT_FSIZE, &limit);
}

[[noreturn]] void become_words(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                               const ProgramLimits& limits, const fs::path& out, const fs::path& err)
{
    if (limits.file_bytes > 0) limit_file_size(limits.file_bytes);
    if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen(err.c_str(), "w", stderr)) _exit(126);
    become_program(words, environment);
}

}  // namespace

ProgramResult run_words(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                        const ProgramLimits& limits)
{
    const TemporaryDirectory directory;
    const fs::path out = directory.path() / "out", err = directory.path() / "err";
    const pid_t child = fork();
    if (child == 0) become_words(words, environment, limits, out, err);
    int status = 0;
    if (!limits.interrupt_at.empty()) {
        while (!fs::exists(limits.interrupt_at) && waitpid(child, &status, WNOHANG) == 0) usleep(1000);
        kill(child, SIGINT);
    }
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(out), read_text(err)};
}

TemporaryDirectory::TemporaryDirectory()
{
    std::string name = (fs::temp_directory_path() / "nuno-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path_ = name;
}

TemporaryDirectory::~TemporaryDirectory()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path TemporaryDirectory::write(const std::string& name, const std::string& text) const
{
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

}  // namespace nuno
