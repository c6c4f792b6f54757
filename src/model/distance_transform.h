// The nearest marked point of a grid for each of its points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nuno {

struct GridSpacing
{
    int columns, rows;
    float dx, dy;  // [m] between columns, between rows
};

// Number of the nearest marked point (column i, row j is j columns + i) for every point, exact (P. Felzenszwalb, D.
// Huttenlocher, Distance transforms of sampled functions, 2012); kNoneMarked where nothing is marked. Of points equally
// near it is any, the same every time.
inline constexpr std::uint32_t kNoneMarked = ~0u;
std::vector<std::uint32_t> nearest_marked(const GridSpacing& grid, std::span<const std::uint8_t> marked);

}  // namespace nuno
