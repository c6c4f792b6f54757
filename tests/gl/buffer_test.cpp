// Bytes come back as they were given, through every way in and out of a buffer.
#include <numeric>
#include <vector>

#include "core/error.h"
#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/gl_test.h"
#include "gl/readback.h"

namespace nuno {
namespace {

using BufferTest = GlTest;

std::vector<float> counting(std::size_t count)
{
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), 0.5f);
    return values;
}

TEST_F(BufferTest, returns_what_it_was_given)
{
    const std::vector<float> given = counting(1000);
    const Buffer buffer = make_buffer(given, GL_STATIC_DRAW);
    std::vector<float> back(given.size());
    buffer.read(0, std::span(back));
    EXPECT_EQ(back, given);
    EXPECT_EQ(buffer.size_bytes(), 4000u);
}

TEST_F(BufferTest, an_update_replaces_only_its_own_part)
{
    Buffer buffer = make_buffer(counting(8), GL_DYNAMIC_DRAW);
    buffer.update(4 * sizeof(float), std::vector<float>{-1.0f, -2.0f});
    std::vector<float> back(8);
    buffer.read(0, std::span(back));
    EXPECT_EQ(back, (std::vector<float>{0.5f, 1.5f, 2.5f, 3.5f, -1.0f, -2.0f, 6.5f, 7.5f}));
}

TEST_F(BufferTest, a_copy_takes_a_part_to_its_place)
{
    const Buffer from = make_buffer(counting(8), GL_DYNAMIC_DRAW), to = make_buffer(counting(6), GL_DYNAMIC_DRAW);
    from.copy_to(5 * sizeof(float), to, sizeof(float), 2 * sizeof(float));
    std::vector<float> back(6);
    to.read(0, std::span(back));
    EXPECT_EQ(back, (std::vector<float>{0.5f, 5.5f, 6.5f, 3.5f, 4.5f, 5.5f}));
}

TEST_F(BufferTest, one_word_and_no_word_are_sizes_like_others)
{
    const Buffer word = make_buffer(std::vector<float>{3.0f}, GL_STATIC_DRAW);
    std::vector<float> back(1);
    word.read(0, std::span(back));
    EXPECT_EQ(back[0], 3.0f);
    const Buffer nothing = make_buffer(std::vector<float>{}, GL_STATIC_DRAW);
    EXPECT_EQ(nothing.size_bytes(), 0u);
    nothing.bind_block(GL_SHADER_STORAGE_BUFFER, 0);
}

TEST_F(BufferTest, a_moved_buffer_keeps_its_name)
{
    Buffer first = make_buffer(counting(4), GL_STATIC_DRAW);
    const GLuint id = first.id();
    const Buffer second = std::move(first);
    EXPECT_EQ(second.id(), id);
    EXPECT_TRUE(glIsBuffer(id));
}

TEST_F(BufferTest, a_readback_hands_out_the_state_at_its_begin)
{
    const std::vector<float> before = counting(5000);
    Buffer buffer = make_buffer(before, GL_DYNAMIC_COPY);
    Readback readback;
    readback.begin(buffer.id(), buffer.size_bytes());
    buffer.update(0, std::vector<float>(5000, 0.0f));
    std::vector<float> back(5000);
    readback.finish(std::span(back));
    EXPECT_EQ(back, before);
    EXPECT_FALSE(readback.pending());
}

TEST_F(BufferTest, a_readback_is_used_again_for_other_sizes)
{
    Readback readback;
    for (const std::size_t count : {10u, 3000u, 7u}) {
        const std::vector<float> given = counting(count);
        const Buffer buffer = make_buffer(given, GL_STATIC_DRAW);
        readback.begin(buffer.id(), buffer.size_bytes());
        std::vector<float> back(count);
        readback.finish(std::span(back));
        EXPECT_EQ(back, given);
    }
}

TEST_F(BufferTest, a_view_with_too_many_texels_is_an_error_with_the_numbers)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    BufferTexture texture(GL_R32F);
    const std::size_t bytes = 4 * (static_cast<std::size_t>(most) + 1);
    try {
        texture.view(0, bytes);
        FAIL() << "the view was accepted";
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(std::to_string(most)), std::string::npos) << what;
        EXPECT_NE(what.find(std::to_string(bytes / 4)), std::string::npos) << what;
    }
}

}  // namespace
}  // namespace nuno
