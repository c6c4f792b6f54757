// Pictures from files, for textures.
#pragma once

#include <filesystem>

#include "render/picture.h"

namespace nuno {

// Reads a BMP (the seed's are 24 bit), PNG, JPEG or TGA file of at most `max_side` pixels a side and 2^26 in all; of 16
// bits a channel the upper 8 are taken. Error naming the path where it is missing, no picture, cut short, without pixels
// or too large.
Picture load_picture(const std::filesystem::path& path, int max_side);

}  // namespace nuno
