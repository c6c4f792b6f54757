// What the overlays of a picture mean: texts and colours, for the window's legend.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

// The bar of colours from 0 to `top`, in `unit`.
struct LegendScale
{
    std::string title, unit;
    double top = 1;
    double largest = 0;  // in the picture
};

// What has one colour (sRGB, 0 .. 1).
struct LegendRow
{
    glm::vec3 colour;
    std::string text;
};

struct OverlayLegend
{
    std::optional<LegendScale> scale;
    std::vector<LegendRow> rows;
    std::vector<std::string> remarks;

    bool empty() const { return !scale && rows.empty() && remarks.empty(); }
};

}  // namespace nuno
