// A program that runs beside the test: what it says on stderr is waited for line by line, and it never outlives the
// test.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace nuno {

// Where and how a program is started.
struct ProgramStart
{
    std::vector<std::string> words;        // the program and its arguments
    std::vector<std::string> environment;  // NAME=VALUE on top of the test's own; an empty VALUE removes NAME
    std::filesystem::path directory;       // to work in; empty: the test's
};

class RunningProgram
{
  public:
    explicit RunningProgram(const ProgramStart& start);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    pid_t pid() const { return pid_; }

    // The groups of the next line that holds `pattern`, after the one that was found last; [0] is what matched.
    // std::runtime_error with everything said so far where none comes in `seconds`, or the program ends before.
    std::vector<std::string> wait_for(const std::string& pattern, double seconds = 30);

    // The groups of the latest line so far that holds `pattern`, wherever the search stands; empty where there is none.
    std::vector<std::string> latest(const std::string& pattern);

    // The exit code, or 128 and the signal. std::runtime_error where it does not end in `seconds`.
    int wait_for_exit(double seconds = 30);
    void signal(int number) const;

    // All lines so far, for messages.
    std::string transcript() const;

  private:
    // Takes what has arrived, after waiting up to `seconds` for it. False where nothing will come any more.
    bool read_more(double seconds);

    pid_t pid_ = -1;
    int pipe_ = -1;
    std::string unfinished_;
    std::vector<std::string> lines_;
    std::size_t next_line_ = 0;
};

// Runs a shell command to its end; its stdout. std::runtime_error where it does not exit 0.
std::string run_shell(const std::string& command);

// True where the shell finds a program of that name.
bool has_program(const std::string& name);

}  // namespace nuno
