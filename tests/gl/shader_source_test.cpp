// Includes, defines and line numbers of shaders, without a driver.
#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "gl/shader_folder.h"

namespace nuno {
namespace {

std::string message_of(std::string_view file)
{
    try {
        expand_shader(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ShaderSource, puts_defines_after_the_version_and_files_in_place_of_includes)
{
    const ShaderFolder folder;
    folder.write("shared/a.h", "int a;\n");
    folder.write("k.comp", "#version 430 core\n#include \"shared/a.h\"\n#include \"shaders/shared/a.h\"\nint k;\n");
    const std::vector<Define> defines = {{"SIZE", "64"}};
    EXPECT_EQ(expand_shader("k.comp", defines).text,
              "#version 430 core\n#define SIZE 64\n#line 2 0\n"
              "#line 1 1\nint a;\n#line 3 0\n"
              "#line 1 2\nint a;\n#line 4 0\n"
              "int k;\n");
}

TEST(ShaderSource, a_generated_text_goes_before_a_file_of_its_name)
{
    const ShaderFolder folder;
    folder.write("k.comp", "#version 430 core\n#include \"sim_params\"\n");
    const std::vector<GeneratedInclude> generated = {{"sim_params", "float wind;\n"}};
    EXPECT_NE(expand_shader("k.comp", {}, generated).text.find("\nfloat wind;\n"), std::string::npos);
}

TEST(ShaderSource, an_unknown_include_is_named_with_file_and_line)
{
    const ShaderFolder folder;
    folder.write("k.comp", "#version 430 core\n\n#include \"shared/nowhere.h\"\n");
    const std::string message = message_of("k.comp");
    EXPECT_NE(message.find("shaders/k.comp:3"), std::string::npos) << message;
    EXPECT_NE(message.find("shared/nowhere.h"), std::string::npos) << message;
}

TEST(ShaderSource, an_include_without_quotes_is_an_error)
{
    const ShaderFolder folder;
    folder.write("k.comp", "#version 430 core\n#include <shared/a.h>\n");
    EXPECT_NE(message_of("k.comp").find("shaders/k.comp:2"), std::string::npos) << message_of("k.comp");
}

TEST(ShaderSource, a_file_that_includes_itself_is_an_error)
{
    const ShaderFolder folder;
    folder.write("loop.h", "#include \"loop.h\"\n");
    folder.write("k.comp", "#version 430 core\n#include \"loop.h\"\n");
    EXPECT_NE(message_of("k.comp").find("include itself"), std::string::npos) << message_of("k.comp");
}

TEST(ShaderSource, another_version_line_is_an_error)
{
    const ShaderFolder folder;
    folder.write("k.comp", "#version 450 core\n");
    EXPECT_NE(message_of("k.comp").find("#version 430 core"), std::string::npos) << message_of("k.comp");
}

TEST(ShaderSource, file_names_replace_numbers_in_the_logs_of_all_drivers)
{
    const ShaderSource source{"", {"shaders/a.comp", "shaders/b.h"}};
    EXPECT_EQ(name_files(source, "1:12(5): error: no\n"), "shaders/b.h:12(5): error: no");
    EXPECT_EQ(name_files(source, "0(7) : error C0000: no"), "shaders/a.comp:7 : error C0000: no");
    EXPECT_EQ(name_files(source, "ERROR: 1:3: no"), "shaders/b.h:3: no");
    EXPECT_EQ(name_files(source, "linking failed"), "linking failed");
    EXPECT_EQ(name_files(source, "9:1: a number of no file"), "9:1: a number of no file");
}

}  // namespace
}  // namespace nuno
