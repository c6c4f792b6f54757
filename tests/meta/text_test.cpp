// Every text of the tree: free of one machine's paths, opened by a line that says what it is for, and short.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "meta/size_rules.h"
#include "meta/tree.h"

namespace nuno::meta {
namespace {

// The first path in `line` that exists on one machine only, or nothing.
std::string machine_path(const std::string& line)
{
    // Written in pieces, so that this file does not find itself.
    static const std::regex pattern(std::string("(^|[^A-Za-z0-9_.})$*-])(/(") + "work|root|home|Users" + ")/[^ ]*)");
    std::smatch match;
    return std::regex_search(line, match, pattern) ? match[2].str() : "";
}

// Whether a source says in its first line what it is for; "#version" must come first in GLSL.
bool has_purpose_line(const std::string& text)
{
    const std::vector<std::string> lines = lines_of(text);
    const std::size_t first = !lines.empty() && lines[0].starts_with("#version") ? 1 : 0;
    return lines.size() > first && lines[first].starts_with("// ") && lines[first].size() > 12;
}

TEST(Text, no_tracked_file_holds_a_path_of_one_machine)
{
    const std::optional<std::vector<std::string>> files = tracked_files();
    if (!files) GTEST_SKIP() << "not a git checkout";
    for (const std::string& file : *files) {
        const std::string text = read_file(file);
        if (text.find('\0') != std::string::npos) continue;
        int number = 0;
        for (const std::string& line : lines_of(text)) {
            ++number;
            EXPECT_EQ(machine_path(line), "") << file << ":" << number;
        }
    }
}

TEST(Text, machine_paths_are_recognised)
{
    const std::string home = std::string("/") + "home/";
    EXPECT_EQ(machine_path("see " + home + "ann/x.h"), home + "ann/x.h");
    EXPECT_EQ(machine_path("\"" + home + "ann\""), home + "ann\"");
    EXPECT_EQ(machine_path(home), home);
    EXPECT_EQ(machine_path("src" + home), "");
    EXPECT_EQ(machine_path("${HOME}" + home), "");
    EXPECT_EQ(machine_path("/usr/include/stb and a/b"), "");
}

TEST(Text, every_source_opens_with_a_line_that_says_what_it_is_for)
{
    std::vector<std::string> files = files_under("src", {".h", ".cpp", ".inc", ".def"});
    const std::vector<std::string> shaders =
        files_under("shaders", {".h", ".glsl", ".comp", ".vert", ".frag", ".geom"});
    files.insert(files.end(), shaders.begin(), shaders.end());
    EXPECT_FALSE(files.empty());
    for (const std::string& file : files) EXPECT_TRUE(has_purpose_line(read_file(file))) << file;
}

TEST(Text, a_missing_purpose_line_is_noticed)
{
    EXPECT_TRUE(has_purpose_line("// Springs of a grid.\n#pragma once\n"));
    EXPECT_TRUE(has_purpose_line("#version 430\n// One Euler step.\n"));
    EXPECT_FALSE(has_purpose_line("#pragma once\n// Springs of a grid.\n"));
    EXPECT_FALSE(has_purpose_line("// x\n"));
    EXPECT_FALSE(has_purpose_line(""));
}

TEST(Text, files_stay_short)
{
    for (const std::string& file : files_under("src", {".h", ".cpp"})) {
        const int limit = file.ends_with(".h") ? kMaxHeaderLines : kMaxSourceLines;
        EXPECT_LE(lines_of(read_file(file)).size(), static_cast<std::size_t>(limit)) << file << ": split it by concept";
    }
}

TEST(Text, functions_stay_short)
{
    for (const std::string& file : files_under("src", {".h", ".cpp"}))
        for (const FunctionSize& function : function_sizes(read_file(file)))
            EXPECT_LE(function.count, kMaxFunctionLines) << file << ":" << function.line << ": split it by concept";
}

TEST(Text, long_functions_are_measured_and_types_are_not)
{
    const std::string body = "    a();\n    b();\n    if (c) {\n        d();\n    }\n";
    const std::vector<FunctionSize> plain = function_sizes("int f(int a,\n      int b)\n{\n" + body + "}\n");
    ASSERT_EQ(plain.size(), 1u);
    EXPECT_EQ(plain[0].line, 3);
    EXPECT_EQ(plain[0].count, 5);

    EXPECT_TRUE(function_sizes("// Why.\nstruct S\n{\n    int a;\n};\n").empty());
    EXPECT_TRUE(function_sizes("template <class T>\nclass S\n{\n    int a;\n};\n").empty());
    EXPECT_EQ(function_sizes("template <class T>\nT f()\n{\n    return {};\n}\n").size(), 1u);

    const std::vector<FunctionSize> member =
        function_sizes("class S\n{\n  public:\n    void f()\n    {\n        g();\n    }\n};\n");
    ASSERT_EQ(member.size(), 1u);
    EXPECT_EQ(member[0].count, 1);
}

}  // namespace
}  // namespace nuno::meta
