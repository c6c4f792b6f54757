// Checks a picture before it is decoded; stb_image fills what is missing from a BMP, JPEG or TGA.
#include "render/texture_file.h"

#include <fmt/format.h>
#include <stb_image.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "core/error.h"
#include "core/files.h"

namespace nuno {
namespace {

constexpr const char* kWanted = "give a BMP, PNG, JPEG or TGA file";

constexpr std::int64_t kMostPixels = 1 << 26;  // 256 MiB of them

constexpr std::size_t kHeaderBytes = 54;   // of a BMP
constexpr std::uint32_t kCoreHeader = 12;  // bytes of the older kind of header, after the first 14

struct BmpHeader
{
    std::uint32_t pixel_offset;
    std::int32_t width, height;  // height < 0: rows top-down
    std::uint16_t bits;
    std::uint32_t compression;
};

template <class T>
T value_at(const std::string& bytes, std::size_t offset)
{
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// Error where an uncompressed BMP has no pixels, or fewer bytes than its header promises.
void check_bmp(const std::string& bytes, const std::string& name)
{
    if (bytes.size() < kHeaderBytes)
        throw Error(fmt::format("{}: is cut short: {} bytes, less than the {} of a BMP header; {}", name, bytes.size(),
                                kHeaderBytes, kWanted));
    if (value_at<std::uint32_t>(bytes, 14) == kCoreHeader)
        throw Error(fmt::format("{}: is a BMP of the kind that OS/2 wrote, which is not read; save it anew, or {}",
                                name, kWanted));
    const BmpHeader header{value_at<std::uint32_t>(bytes, 10), value_at<std::int32_t>(bytes, 18),
                           value_at<std::int32_t>(bytes, 22), value_at<std::uint16_t>(bytes, 28),
                           value_at<std::uint32_t>(bytes, 30)};
    if (header.width <= 0 || header.height == 0)
        throw Error(
            fmt::format("{}: has {} x {} pixels; {} of at least 1 x 1", name, header.width, header.height, kWanted));
    if (header.compression != 0) return;
    const std::uint64_t row = (std::uint64_t(header.width) * header.bits + 31) / 32 * 4;
    const std::uint64_t needed = header.pixel_offset + row * std::uint64_t(std::abs(std::int64_t(header.height)));
    if (bytes.size() < needed)
        throw Error(fmt::format("{}: is cut short: {} bytes, but its {} x {} pixels of {} bits need {}; copy it again",
                                name, bytes.size(), header.width, header.height, header.bits, needed));
}

// Error where a JPEG has no end-of-image mark after its last scan; within a scan no byte 0xff is followed by these.
void check_jpeg(const std::string& bytes, const std::string& name)
{
    const std::size_t scan = bytes.rfind("\xff\xda");
    if (scan != bytes.npos && bytes.find("\xff\xd9", scan) == bytes.npos)
        throw Error(
            fmt::format("{}: is cut short: a JPEG of {} bytes without its end; copy it again", name, bytes.size()));
}

// Error where an uncompressed TGA has fewer bytes than its header promises.
void check_tga(const std::string& bytes, const std::string& name)
{
    constexpr std::size_t header_bytes = 18;
    if (bytes.size() < header_bytes) return;
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
    const std::size_t palette = byte(1) == 0 ? 0 : value_at<std::uint16_t>(bytes, 5) * ((byte(7) + 7u) / 8);
    const std::size_t pixels = std::size_t(value_at<std::uint16_t>(bytes, 12)) * value_at<std::uint16_t>(bytes, 14);
    const bool packed = byte(2) > 8;
    const std::size_t needed = header_bytes + byte(0) + palette + (packed ? 0 : pixels * ((byte(16) + 7u) / 8));
    if (bytes.size() < needed)
        throw Error(fmt::format("{}: is cut short: {} bytes, but its {} pixels of {} bits need {}; copy it again", name,
                                bytes.size(), pixels, byte(16), needed));
}

}  // namespace

Picture load_picture(const std::filesystem::path& path, int max_side)
{
    const std::string name = path.string();
    const std::string bytes = read_text(path);
    if (bytes.empty()) throw Error(fmt::format("{}: is empty; {}", name, kWanted));
    if (bytes.starts_with("BM")) check_bmp(bytes, name);
    if (bytes.starts_with("\xff\xd8")) check_jpeg(bytes, name);
    if (path.extension() == ".tga" || path.extension() == ".TGA") check_tga(bytes, name);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Picture picture;
    int channels = 0;
    if (!stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels))
        throw Error(fmt::format("{}: is no picture that can be read ({}); {}", name, stbi_failure_reason(), kWanted));
    if (picture.width > max_side || picture.height > max_side)
        throw Error(fmt::format("{}: has {} x {} pixels, but this device takes {} a side; make it smaller", name,
                                picture.width, picture.height, max_side));
    if (std::int64_t(picture.width) * picture.height > kMostPixels)
        throw Error(
            fmt::format("{}: has {} x {} pixels, more than the {} that are read; make it smaller, such as 4096 "
                        "x 4096",
                        name, picture.width, picture.height, kMostPixels));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &picture.width, &picture.height, &channels, 4), stbi_image_free);
    if (!pixels) throw Error(fmt::format("{}: cannot be decoded ({}); {}", name, stbi_failure_reason(), kWanted));
    picture.rgba.assign(pixels.get(), pixels.get() + 4 * std::size_t(picture.width) * std::size_t(picture.height));
    return picture;
}

}  // namespace nuno
