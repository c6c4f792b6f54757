// The surface of a plain weave, as the texture of the look `cloth`.
#pragma once

#include <cstdint>
#include <vector>

namespace nuno {

// Texels a side of the picture, which repeats in both directions and shows WEAVE_THREADS threads each way.
constexpr int kWeaveSide = 512;

// RGBA, 8 bits each: the slope of the surface along u and along v, 0 at 128 and 2 at 255; how bright the thread is, dye
// and hollow together, WEAVE_BRIGHTEST times the mean at 255; 255. Threads are as uneven as spun ones, the same each time.
std::vector<std::uint8_t> weave_texels();

}  // namespace nuno
