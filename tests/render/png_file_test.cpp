// PNG files hold exactly the pixels they were made from.
#include "render/png_file.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/temporary_folder.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

Picture gradient(int width, int height)
{
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.rgba.insert(picture.rgba.end(), {std::uint8_t(x), std::uint8_t(7 * y), std::uint8_t(x * y), 255});
    return picture;
}

TEST(PngFile, another_decoder_reads_the_same_pixels)
{
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(37, 23), std::pair(320, 180)}) {
        const Picture picture = gradient(width, height);
        write_png(folder / "picture.png", picture);
        const Picture back = load_picture(folder / "picture.png", 4096);
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.rgba, picture.rgba);
    }
}

TEST(PngFile, a_picture_without_pixels_is_an_error) { EXPECT_THROW(encode_png(Picture{}), Error); }

TEST(PngFile, a_file_that_cannot_be_written_is_an_error_that_names_it)
{
    try {
        write_png("/proc/nowhere/frame.png", gradient(4, 4));
        FAIL() << "the file was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("/proc/nowhere/frame.png"), 0u) << error.what();
    }
}

}  // namespace
}  // namespace nuno
