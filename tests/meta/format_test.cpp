// The layout of every C++ file is the one that .clang-format gives. `ninja -C build/release format` puts it right.
#include <gtest/gtest.h>

#include "meta/tree.h"

namespace nuno::meta {
namespace {

constexpr const char* kFormatter = "clang-format-14";

TEST(Format, every_cpp_file_has_the_layout_of_clang_format)
{
    if (run_command(std::string("command -v ") + kFormatter).exit_code != 0)
        GTEST_SKIP() << kFormatter << " is not installed";
    std::string command = std::string(kFormatter) + " --dry-run -Werror --style=file";
    for (const char* folder : {"src", "tests", "bench", "shaders"})
        for (const std::string& file : files_under(folder, {".h", ".cpp"})) command += " '" + file + "'";
    const CommandResult checked = run_command(command);
    EXPECT_EQ(checked.exit_code, 0) << checked.output << "\nninja -C build/release format puts it right";
}

TEST(Format, a_wrong_layout_is_noticed)
{
    if (run_command(std::string("command -v ") + kFormatter).exit_code != 0)
        GTEST_SKIP() << kFormatter << " is not installed";
    const std::string command = std::string(" | ") + kFormatter + " --dry-run -Werror --assume-filename=src/x.cpp";
    EXPECT_EQ(run_command("printf 'int* a;\\n'" + command).exit_code, 0);
    EXPECT_NE(run_command("printf 'int *a ;\\n'" + command).exit_code, 0);
}

}  // namespace
}  // namespace nuno::meta
