// Pixels on the CPU.
#pragma once

#include <cstdint>
#include <vector>

namespace nuno {

struct Picture
{
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  // 4 width height bytes, sRGB, rows top-down
};

}  // namespace nuno
