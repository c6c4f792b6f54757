// What the user did wrong, or what the run met: thrown anywhere, caught once in main, printed as one message.
#pragma once

#include <stdexcept>
#include <string>

namespace nuno {

// Exit codes of the program (docs/cli.md).
enum class ExitCode : int
{
    done = 0,
    check_failed = 1,
    bad_input = 2,
    went_bad = 3,
    interrupted = 130,
};

// The user's input is wrong. `what()` says where, what, and what would be right, in one line.
class Error : public std::runtime_error
{
  public:
    explicit Error(const std::string& message, ExitCode code = ExitCode::bad_input)
        : std::runtime_error(message), code_(code)
    {
    }
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

}  // namespace nuno
