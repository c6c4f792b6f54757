// The headless context: what it offers, how it reports errors, and what it says where OpenGL is too old.
#include <cstdio>
#include <cstdlib>

#include "core/error.h"
#include "gl/gl_test.h"

namespace nuno {
namespace {

using ContextTest = GlTest;

TEST_F(ContextTest, offers_at_least_4_3_core)
{
    GLint major = 0, minor = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 43);
    EXPECT_TRUE(profile & GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_NE(gl_info().renderer, "unknown");
}

TEST_F(ContextTest, tells_an_error_once)
{
    glEnable(0xdead);
    EXPECT_FALSE(take_gl_errors().empty());
    EXPECT_TRUE(take_gl_errors().empty());
}

TEST_F(ContextTest, a_second_context_lives_beside_the_first)
{
    {
        const std::unique_ptr<Context> second = make_headless_context();
        EXPECT_NE(gl_info().version, "unknown");
    }
    const std::unique_ptr<Context> third = make_headless_context();
    EXPECT_NE(gl_info().version, "unknown");
}

TEST(GlInfoTest, knows_the_names_of_software_renderers)
{
    EXPECT_TRUE(is_software_renderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(is_software_renderer("Google SwiftShader"));
    EXPECT_TRUE(is_software_renderer("softpipe"));
    EXPECT_FALSE(is_software_renderer("NVIDIA GeForce RTX 3060/PCIe/SSE2"));
    EXPECT_FALSE(is_software_renderer("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"));
}

// Prints the message of the Error and leaves with its exit code, as main does.
[[noreturn]] void report_context(const char* version)
{
    setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    try {
        const std::unique_ptr<Context> context = make_headless_context();
    } catch (const Error& error) {
        std::fputs(error.what(), stderr);
        std::exit(static_cast<int>(error.code()));
    }
    std::exit(0);
}

TEST(OldGlTest, an_older_version_is_named_with_its_renderer_and_what_is_needed)
{
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_EXIT(report_context("3.3"), testing::ExitedWithCode(2), "version 3\\.3.*llvmpipe.*4\\.3 core is needed");
}

}  // namespace
}  // namespace nuno
