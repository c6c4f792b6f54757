// Off-screen pictures and textures keep the colours they are given.
#include <vector>

#include "core/error.h"
#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/gl_test.h"
#include "gl/program.h"
#include "gl/shader_folder.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"

namespace nuno {
namespace {

using FramebufferTest = GlTest;

// Left half red, lower half of it bright.
void draw_quadrants(const Framebuffer& target)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, target.width(), target.height());
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, target.width() / 2, target.height() / 2);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

TEST_F(FramebufferTest, rows_come_back_top_down_with_and_without_samples)
{
    for (const int samples : {1, 4}) {
        const Framebuffer target(8, 6, samples);
        draw_quadrants(target);
        target.resolve();
        std::vector<std::uint8_t> pixels;
        target.read_rgba(pixels);
        ASSERT_EQ(pixels.size(), 4u * 8 * 6);
        EXPECT_EQ(pixels[0], 0) << "the top left is black";
        EXPECT_EQ(pixels[4 * 8 * 5], 255) << "the bottom left is red";
        EXPECT_EQ(pixels[4 * 8 * 5 + 4 * 7], 0) << "the bottom right is black";
    }
}

TEST_F(FramebufferTest, samples_are_lowered_to_what_the_device_can)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    EXPECT_EQ(Framebuffer(8, 8, 1000).samples(), most);
}

TEST_F(FramebufferTest, an_impossible_size_is_an_error)
{
    EXPECT_THROW(Framebuffer(0, 8, 1), Error);
    EXPECT_THROW(Framebuffer(1 << 24, 8, 1), Error);
}

TEST_F(FramebufferTest, a_texture_shows_its_pixels_where_the_coordinates_say)
{
    const ShaderFolder folder;
    folder.write("show.vert",
                 "#version 430 core\nlayout(location = 0) in vec2 corner;\nout vec2 uv;\n"
                 "void main() { uv = 0.5 * corner + 0.5; gl_Position = vec4(corner, 0.0, 1.0); }\n");
    folder.write("show.frag",
                 "#version 430 core\nlayout(binding = 3) uniform sampler2D picture;\nin vec2 uv;\nout vec4 colour;\n"
                 "void main() { colour = textureLod(picture, uv, 0.0); }\n");
    const Program program = draw_program("show.vert", "show.frag");
    const std::vector<std::uint8_t> rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
    const Texture texture(2, 2, rgba);
    const Buffer corners = make_buffer(std::vector<float>{-1, -1, 3, -1, -1, 3}, GL_STATIC_DRAW);
    VertexArray vertices;
    vertices.attribute(0, 0, 2);
    vertices.vertices(0, corners.id(), 2 * sizeof(float));
    const Framebuffer target(2, 2, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, 2, 2);
    texture.bind(3);
    program.use();
    vertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::uint8_t> pixels;
    target.read_rgba(pixels);
    // The first row of a texture is its lowest.
    EXPECT_EQ(pixels, (std::vector<std::uint8_t>{0, 0, 255, 255, 255, 255, 255, 255, 255, 0, 0, 255, 0, 255, 0, 255}));
}

}  // namespace
}  // namespace nuno
