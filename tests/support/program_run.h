// Runs a program as a user would, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nuno {

struct ProgramResult
{
    int exit_code = -1;
    std::string out, err;
};

struct ProgramLimits
{
    long file_bytes = 0;  // where over 0, a write beyond so many bytes of a file fails, as on a full disk
    // Where not empty, SIGINT is sent as soon as this path exists.
    std::filesystem::path interrupt_at;
};

// Runs words[0] with the other words.
ProgramResult run_words(const std::vector<std::string>& words, const std::vector<std::string>& environment = {},
                        const ProgramLimits& limits = {});

// Runs `nuno WORDS...` (to link: nuno_test_program) with further NAME=VALUE settings in its environment (an empty VALUE removes NAME).
ProgramResult run_program(const std::vector<std::string>& words, const std::vector<std::string>& environment = {},
                          const ProgramLimits& limits = {});

// A directory of its own for one test, removed with the object.
class TemporaryDirectory
{
  public:
    TemporaryDirectory();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

}  // namespace nuno
