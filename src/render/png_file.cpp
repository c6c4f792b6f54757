// libpng at its fastest useful setting: on a frame of cloth, several times faster than its default and little larger.
#include "render/png_file.h"

#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <new>

#include "core/error.h"
#include "core/files.h"

namespace nuno {
namespace {

// What the callbacks of libpng reach: it leaves by longjmp, so nothing that has a destructor lives in the frames it
// crosses.
struct Encoder
{
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<std::byte> bytes;

    Encoder() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr))
    {
        if (!png) throw std::bad_alloc();
        info = png_create_info_struct(png);
    }
    ~Encoder() { png_destroy_write_struct(&png, &info); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
};

void append(png_structp png, png_bytep from, png_size_t count)
{
    auto& bytes = static_cast<Encoder*>(png_get_io_ptr(png))->bytes;
    try {
        const auto* first = reinterpret_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), first, first + count);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");
    }
}

void no_flush(png_structp) {}

// False where libpng gave up.
bool encode(Encoder& encoder, const Picture& picture)
{
    const png_structp png = encoder.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &encoder, append, no_flush);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(png, encoder.info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, encoder.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, encoder.info);
    png_set_filler(png, 0, PNG_FILLER_AFTER);
    const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
    for (int y = 0; y < picture.height; ++y)
        png_write_row(png, picture.rgba.data() + row * static_cast<std::size_t>(y));
    png_write_end(png, encoder.info);
    return true;
}

}  // namespace

std::vector<std::byte> encode_png(const Picture& picture)
{
    Encoder encoder;
    const bool possible = picture.width > 0 && picture.height > 0 && encoder.info;
    if (!possible || !encode(encoder, picture))
        throw Error("PNG: a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                    " pixels cannot be encoded; give it at least one pixel, and free some memory");
    return std::move(encoder.bytes);
}

void write_png(const std::filesystem::path& path, const Picture& picture) { write_whole(path, encode_png(picture)); }

}  // namespace nuno
