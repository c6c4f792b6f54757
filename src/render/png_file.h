// PNG files of rendered frames: compressed little, so that writing them does not outlast rendering them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "render/picture.h"

namespace nuno {

// The bytes of an 8-bit RGB file; alpha is dropped. Error where the picture has no pixels.
std::vector<std::byte> encode_png(const Picture& picture);

// Encodes and writes it whole (core/files.h). Error naming the path where the disk refuses.
void write_png(const std::filesystem::path& path, const Picture& picture);

}  // namespace nuno
