// Programs: a kernel runs, and what is wrong with one is told with file and line.
#include <vector>

#include "core/error.h"
#include "gl/barriers.h"
#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/gl_test.h"
#include "gl/program.h"
#include "gl/shader_folder.h"

namespace nuno {
namespace {

constexpr std::string_view kScale = R"(#version 430 core
layout(local_size_x = 8) in;
layout(binding = 0) uniform samplerBuffer from;
layout(binding = 1, std430) buffer To { float to[]; };
layout(location = 0) uniform float factor;
void main()
{
    to[gl_GlobalInvocationID.x] = FACTOR(factor) * texelFetch(from, int(gl_GlobalInvocationID.x)).x;
}
)";

using ProgramTest = GlTest;

TEST_F(ProgramTest, a_kernel_reads_a_buffer_texture_and_writes_a_block)
{
    const ShaderFolder folder;
    folder.write("scale.comp", kScale);
    const Program program = compute_program("scale.comp", {{"FACTOR(x)", "(2.0 * (x))"}});
    const Buffer from = make_buffer(std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8}, GL_STATIC_DRAW);
    const Buffer to(from.size_bytes(), nullptr, GL_DYNAMIC_COPY);
    BufferTexture texture(GL_R32F);
    texture.view(from.id(), from.size_bytes());
    texture.bind(0);
    to.bind_block(GL_SHADER_STORAGE_BUFFER, 1);
    program.set(0, 5.0f);
    program.use();
    glDispatchCompute(1, 1, 1);
    barrier_compute_to_readback();
    std::vector<float> back(8);
    to.read(0, std::span(back));
    EXPECT_EQ(back, (std::vector<float>{10, 20, 30, 40, 50, 60, 70, 80}));
}

TEST_F(ProgramTest, every_barrier_is_accepted)
{
    barrier_compute_to_compute();
    barrier_compute_to_draw();
    barrier_draw_to_compute();
    barrier_compute_to_readback();
    barrier_compute_to_upload();
    EXPECT_TRUE(take_gl_errors().empty());
}

std::string message_of(std::string_view file)
{
    try {
        compute_program(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(ProgramTest, an_error_names_the_file_and_line_it_stands_in)
{
    const ShaderFolder folder;
    folder.write("wrong.comp",
                 "#version 430 core\nlayout(local_size_x = 1) in;\nvoid main()\n{\n    float x = missing;\n}\n");
    EXPECT_NE(message_of("wrong.comp").find("shaders/wrong.comp:5"), std::string::npos) << message_of("wrong.comp");
}

TEST_F(ProgramTest, an_error_in_an_included_file_names_that_file)
{
    const ShaderFolder folder;
    folder.write("shared/bad.h", "// Three lines.\n\nfloat bad() { return missing; }\n");
    folder.write("wrong.comp",
                 "#version 430 core\nlayout(local_size_x = 1) in;\n#include \"shared/bad.h\"\nvoid main() {}\n");
    EXPECT_NE(message_of("wrong.comp").find("shaders/shared/bad.h:3"), std::string::npos) << message_of("wrong.comp");
}

TEST_F(ProgramTest, an_error_after_an_include_keeps_its_own_line)
{
    const ShaderFolder folder;
    folder.write("shared/good.h", "float good() { return 1.0; }\n\n\n");
    folder.write(
        "wrong.comp",
        "#version 430 core\nlayout(local_size_x = 1) in;\n#include \"shared/good.h\"\nvoid main() { missing(); }\n");
    EXPECT_NE(message_of("wrong.comp").find("shaders/wrong.comp:4"), std::string::npos) << message_of("wrong.comp");
}

}  // namespace
}  // namespace nuno
