// Pictures from files: the seed's 24-bit BMP, and an error that names the file for all that is wrong with one.
#include "render/texture_file.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <cstring>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "render/temporary_folder.h"

namespace nuno {
namespace {

// An uncompressed BMP of 24 bits, rows bottom-up, pixel (x, y) from the top left coloured (10 x, 20 y, 30).
std::string bmp(std::int32_t width, std::int32_t height)
{
    const std::size_t row = (std::size_t(width) * 3 + 3) / 4 * 4;
    std::string bytes(54 + row * std::size_t(height), '\0');
    const auto put = [&](std::size_t at, std::int32_t value) { std::memcpy(bytes.data() + at, &value, 4); };
    bytes[0] = 'B';
    bytes[1] = 'M';
    put(2, static_cast<std::int32_t>(bytes.size()));
    put(10, 54);
    put(14, 40);
    put(18, width);
    put(22, height);
    put(26, 1 | 24 << 16);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            char* p = bytes.data() + 54 + row * std::size_t(height - 1 - y) + 3 * std::size_t(x);
            p[0] = 30;
            p[1] = static_cast<char>(20 * y);
            p[2] = static_cast<char>(10 * x);
        }
    return bytes;
}

std::string png_chunk(const std::string& type, const std::string& content)
{
    const std::string length{0, 0, char(content.size() >> 8), char(content.size())};
    return length + type + content + "sum.";
}

// A PNG of RGB pixels, `bits` a channel, whose rows are `raw`, each after its byte of filter; the sums are not looked at.
std::string png(int width, int height, int bits, const std::string& raw)
{
    const auto low = [&raw](int flip) {
        return std::string{char(int(raw.size()) ^ flip), char((int(raw.size()) >> 8) ^ flip)};
    };
    const std::string size{0, 0, char(width >> 8), char(width), 0, 0, char(height >> 8), char(height)};
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", size + char(bits) + "\2" + std::string(3, '\0')) +
           png_chunk("IDAT", "\x78\x01\x01" + low(0) + low(-1) + raw + "sum.") + png_chunk("IEND", "");
}

class TextureFileTest : public testing::Test
{
  protected:
    std::string message_of(const std::string& bytes)
    {
        write_whole(path, bytes);
        return message_of_file();
    }
    std::string message_of_file()
    {
        try {
            load_picture(path, 64);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find(path.string()), 0u) << error.what();
            return error.what();
        }
        return "no error";
    }
    TemporaryFolder folder;
    std::filesystem::path path = folder / "cloth.bmp";
};

TEST_F(TextureFileTest, a_24_bit_bmp_is_read_top_down)
{
    write_whole(path, bmp(3, 2));
    const Picture picture = load_picture(path, 64);
    ASSERT_EQ(picture.width, 3);
    ASSERT_EQ(picture.height, 2);
    EXPECT_EQ(picture.rgba, (std::vector<std::uint8_t>{0, 0,  30, 255, 10, 0,  30, 255, 20, 0,  30, 255,
                                                       0, 20, 30, 255, 10, 20, 30, 255, 20, 20, 30, 255}));
}

TEST_F(TextureFileTest, the_shipped_textures_are_24_bit_and_small)
{
    for (const char* name : {"weave.bmp", "stripe.bmp", "print.bmp"}) {
        const std::filesystem::path texture = root_directory() / "assets/textures" / name;
        EXPECT_EQ(load_picture(texture, 4096).width, 256) << name;
        EXPECT_EQ(read_text(texture)[28], 24) << name;
        EXPECT_LT(std::filesystem::file_size(texture), 200'000u) << name;
    }
}

TEST_F(TextureFileTest, a_picture_of_one_pixel_is_read)
{
    write_whole(path, bmp(1, 1));
    EXPECT_EQ(load_picture(path, 64).rgba, (std::vector<std::uint8_t>{0, 0, 30, 255}));
}

TEST_F(TextureFileTest, a_bmp_with_a_palette_is_read)
{
    std::string bytes = bmp(2, 1).substr(0, 54);
    bytes[10] = 54 + 8;  // pixels after two colours of blue, green, red, 0
    bytes[28] = 8;       // bits
    bytes[46] = 2;       // colours
    bytes += std::string("\1\2\3\0\4\5\6\0", 8) + std::string("\1\0\0\0", 4);
    write_whole(path, bytes);
    EXPECT_EQ(load_picture(path, 64).rgba, (std::vector<std::uint8_t>{6, 5, 4, 255, 3, 2, 1, 255}));
}

TEST_F(TextureFileTest, a_bmp_of_16_bits_a_pixel_is_read)
{
    std::string bytes = bmp(2, 1).substr(0, 54);
    bytes[28] = 16;                               // bits: 1 unused, then 5 each of red, green, blue
    bytes += std::string("\x1f\x00\x00\x7c", 4);  // blue, red
    write_whole(path, bytes);
    EXPECT_EQ(load_picture(path, 64).rgba, (std::vector<std::uint8_t>{0, 0, 255, 255, 255, 0, 0, 255}));
}

TEST_F(TextureFileTest, of_16_bits_a_channel_the_upper_8_are_taken)
{
    write_whole(path, png(1, 1, 16, std::string("\0\x10\xff\x20\x00\x30\x80", 7)));
    EXPECT_EQ(load_picture(path, 64).rgba, (std::vector<std::uint8_t>{0x10, 0x20, 0x30, 255}));
}

TEST_F(TextureFileTest, a_picture_with_too_many_pixels_is_an_error)
{
    write_whole(path, png(16384, 16384, 8, ""));
    try {
        load_picture(path, 16384);
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("16384 x 16384 pixels, more than"), std::string::npos) << error.what();
    }
}

TEST_F(TextureFileTest, a_png_that_is_cut_short_is_an_error_at_any_length)
{
    const std::string whole = png(2, 2, 8, std::string(2 * 7, '\0'));
    ASSERT_EQ(message_of(whole), "no error");
    // The last 4 bytes are a sum that is not looked at.
    for (std::size_t length = 1; length < whole.size() - 4; ++length)
        EXPECT_NE(message_of(whole.substr(0, length)), "no error") << length << " bytes";
}

TEST_F(TextureFileTest, a_jpeg_or_tga_that_is_cut_short_is_an_error)
{
    std::vector<std::uint8_t> noise(3 * 32 * 32);
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<std::uint8_t>(i * i * 31);
    stbi_write_jpg(path.c_str(), 32, 32, 3, noise.data(), 90);
    const std::string jpeg = read_text(path);
    EXPECT_EQ(load_picture(path, 64).width, 32);
    for (const std::size_t length : {jpeg.size() / 2, jpeg.size() - 1})
        EXPECT_NE(message_of(jpeg.substr(0, length)).find("cut short"), std::string::npos) << length << " bytes";
    path.replace_extension(".tga");
    stbi_write_tga_with_rle = 0;
    stbi_write_tga(path.c_str(), 32, 32, 3, noise.data());
    const std::string tga = read_text(path);
    EXPECT_EQ(load_picture(path, 64).width, 32);
    EXPECT_NE(message_of(tga.substr(0, tga.size() / 2)).find("cut short"), std::string::npos);
}

TEST_F(TextureFileTest, a_missing_file_is_an_error)
{
    EXPECT_NE(message_of_file().find("cannot be read"), std::string::npos);
}

TEST_F(TextureFileTest, an_empty_file_is_an_error) { EXPECT_NE(message_of("").find("is empty"), std::string::npos); }

TEST_F(TextureFileTest, a_bmp_that_is_cut_short_is_an_error_at_any_length)
{
    const std::string whole = bmp(4, 4);
    for (const std::size_t length : {std::size_t(2), std::size_t(53), std::size_t(54), whole.size() - 1})
        EXPECT_NE(message_of(whole.substr(0, length)).find("cut short"), std::string::npos) << length << " bytes";
}

TEST_F(TextureFileTest, a_bmp_without_pixels_is_an_error)
{
    EXPECT_NE(message_of(bmp(0, 4)).find("0 x 4 pixels"), std::string::npos);
    EXPECT_NE(message_of(bmp(4, 0)).find("4 x 0 pixels"), std::string::npos);
}

TEST_F(TextureFileTest, a_bmp_with_a_monstrous_size_is_an_error)
{
    std::string bytes = bmp(4, 4);
    const std::int32_t most = 0x7fffffff;
    std::memcpy(bytes.data() + 18, &most, 4);
    std::memcpy(bytes.data() + 22, &most, 4);
    EXPECT_NE(message_of(bytes).find("cut short"), std::string::npos);
}

TEST_F(TextureFileTest, a_picture_larger_than_the_device_takes_is_an_error)
{
    EXPECT_NE(message_of(bmp(65, 4)).find("takes 64 a side"), std::string::npos);
}

TEST_F(TextureFileTest, a_file_that_is_no_picture_is_an_error)
{
    EXPECT_NE(message_of("v 0 0 0\nf 1 2 3\n").find("is no picture"), std::string::npos);
}

}  // namespace
}  // namespace nuno
