// A folder that lives as long as one test.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace nuno {

class TemporaryFolder
{
  public:
    TemporaryFolder() : path_(std::filesystem::temp_directory_path() / ("nuno-render-" + std::to_string(getpid())))
    {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

}  // namespace nuno
