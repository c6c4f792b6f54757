// Chooses the strips of a grid sheet.
#include "solver/xpbd/strip_layout.h"

#include <algorithm>

namespace nuno {
namespace {

// A spring over two columns must not reach past the next strip and come back to its own vector.
constexpr int kLeastWidth = 3;

int width_of(int columns) { return std::max((columns + kStrips - 1) / kStrips, kLeastWidth); }

// Rows whose starts are a multiple of 4 KiB apart would share cache sets, and loads from one would wait for stores to
// another.
int row_floats_of(int width)
{
    constexpr int page_floats = 1024;
    int floats = width * kVec3Floats;
    while (2 * floats % page_floats < 2 * kStrips) floats += kStrips;
    return floats;
}

}  // namespace

StripLayout make_strip_layout(int columns, int rows)
{
    StripLayout layout{columns, rows, width_of(columns), 0, false};
    // Turning the sheet must pay: as it is, the sweep runs along the pins of a sheet that hangs from its first row.
    if (2 * width_of(rows) * columns < width_of(columns) * rows) layout = {rows, columns, width_of(rows), 0, true};
    layout.row_floats = row_floats_of(layout.width);
    return layout;
}

}  // namespace nuno
