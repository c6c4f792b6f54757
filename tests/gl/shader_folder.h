// A folder of shaders made for one test, which takes the place of the program's own.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files.h"

namespace nuno {

class ShaderFolder
{
  public:
    ShaderFolder() : root_(std::filesystem::temp_directory_path() / ("nuno-shaders-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(root_ / "shaders");
        setenv("NUNO_ROOT", root_.c_str(), 1);
    }
    ~ShaderFolder()
    {
        unsetenv("NUNO_ROOT");
        std::filesystem::remove_all(root_);
    }
    ShaderFolder(const ShaderFolder&) = delete;
    ShaderFolder& operator=(const ShaderFolder&) = delete;

    void write(std::string_view file, std::string_view text) const
    {
        const std::filesystem::path path = root_ / "shaders" / file;
        std::filesystem::create_directories(path.parent_path());
        write_whole(path, text);
    }

  private:
    std::filesystem::path root_;
};

}  // namespace nuno
