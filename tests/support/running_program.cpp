// Starts programs and reads what they say.
#include "support/running_program.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "support/child_process.h"

namespace nuno {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_until(Clock::time_point deadline)
{
    return std::chrono::duration<double>(deadline - Clock::now()).count();
}

Clock::time_point after(double seconds)
{
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

[[noreturn]] void become(const ProgramStart& start, int err)
{
    dup2(err, STDERR_FILENO);
    if (!start.directory.empty() && chdir(start.directory.c_str()) != 0) _exit(126);
    become_program(start.words, start.environment);
}

std::vector<std::string> groups_of(const std::smatch& match) { return {match.begin(), match.end()}; }

}  // namespace

RunningProgram::RunningProgram(const ProgramStart& start)
{
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ == 0) {
        close(ends[0]);
        become(start, ends[1]);
    }
    close(ends[1]);
    pipe_ = ends[0];
}

RunningProgram::~RunningProgram()
{
    close(pipe_);
    if (pid_ <= 0) return;
    signal(SIGKILL);
    waitpid(pid_, nullptr, 0);
}

void RunningProgram::signal(int number) const
{
    if (pid_ > 0) kill(pid_, number);
}

bool RunningProgram::read_more(double seconds)
{
    pollfd waiting{pipe_, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(seconds * 1000) + 1) <= 0) return true;
    char block[4096];
    const ssize_t count = read(pipe_, block, sizeof block);
    if (count <= 0) return false;
    unfinished_.append(block, static_cast<std::size_t>(count));
    for (std::size_t end; (end = unfinished_.find('\n')) != std::string::npos; unfinished_.erase(0, end + 1))
        lines_.push_back(unfinished_.substr(0, end));
    return true;
}

std::vector<std::string> RunningProgram::wait_for(const std::string& pattern, double seconds)
{
    const std::regex wanted(pattern);
    const Clock::time_point deadline = after(seconds);
    for (bool open = true;;) {
        for (std::smatch match; next_line_ < lines_.size();)
            if (std::regex_search(lines_[next_line_++], match, wanted)) return groups_of(match);
        if (!open || seconds_until(deadline) <= 0)
            throw std::runtime_error("no line '" + pattern + "' " + (open ? "in time" : "before the end") +
                                     "; it said:\n" + transcript());
        open = read_more(seconds_until(deadline));
    }
}

std::vector<std::string> RunningProgram::latest(const std::string& pattern)
{
    for (pollfd waiting{pipe_, POLLIN, 0}; poll(&waiting, 1, 0) > 0 && read_more(0);) continue;
    const std::regex wanted(pattern);
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
        if (std::smatch match; std::regex_search(*line, match, wanted)) return groups_of(match);
    return {};
}

int RunningProgram::wait_for_exit(double seconds)
{
    const Clock::time_point deadline = after(seconds);
    while (read_more(seconds_until(deadline)))
        if (seconds_until(deadline) <= 0) throw std::runtime_error("does not end; it said:\n" + transcript());
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string RunningProgram::transcript() const
{
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    return text;
}

std::string run_shell(const std::string& command)
{
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot start: " + command);
    std::string output;
    char block[4096];
    for (std::size_t count; (count = fread(block, 1, sizeof block, pipe)) > 0;) output.append(block, count);
    if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command + "\n" + output);
    return output;
}

bool has_program(const std::string& name)
{
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace nuno
