// Where the vertices of a grid sheet lie so that vectors of kStrips lanes sweep it without gathers: each lane owns a
// strip of neighbouring columns, so the next column of all strips is the next vector.
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/cloth_model.h"
#include "solver/base/aligned_floats.h"

namespace nuno {

// The same on every machine, so that the order of constraints, and with it every bit, is.
constexpr int kStrips = 16;
// Floats of a vector of positions: kStrips x, then y, then z.
constexpr int kVec3Floats = 3 * kStrips;

using StripLanes = AlignedFloats;

// Column i of a row is lane i / width of vector i % width; lanes past the last column are padding, which no spring
// joins to the sheet. Rows of the layout are the rows of the sheet, or its columns where that leaves less padding.
struct StripLayout
{
    int columns = 0, rows = 0;  // of the layout
    int width = 0;              // vectors a row
    int row_floats = 0;         // from one row of positions to the next
    bool transposed = false;

    std::size_t vec3(int i, int j) const
    {
        return static_cast<std::size_t>(j) * row_floats + static_cast<std::size_t>(i % width * kVec3Floats + i / width);
    }
    std::size_t lane(int i, int j) const
    {
        return (static_cast<std::size_t>(j) * width + i % width) * kStrips + static_cast<std::size_t>(i / width);
    }
    std::size_t vec3_floats() const { return static_cast<std::size_t>(rows) * row_floats + kStrips; }
    std::size_t lane_floats() const { return static_cast<std::size_t>(rows) * width * kStrips; }
    // Vertex of the model at column i, row j of the layout.
    std::uint32_t vertex(const Sheet& sheet, int i, int j) const
    {
        return transposed ? sheet.grid_vertex(j, i) : sheet.grid_vertex(i, j);
    }
};

StripLayout make_strip_layout(int columns, int rows);

}  // namespace nuno
