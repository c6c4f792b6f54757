// Gauss-Seidel over the springs of a grid sheet in strips: the constraints of one row after another, and the exact
// reverse.
#pragma once

#include <array>

#include "core/thread_pool.h"
#include "solver/xpbd/strip_layout.h"

namespace nuno {

// The springs that a row j owns, in the order in which it projects them: within the row, to row j + 1, to row j + 2.
enum StripSpring : int
{
    kAcross,
    kTwoAcross,
    kDown,
    kDownRight,  // (i, j) to (i + 1, j + 1)
    kDownLeft,   // (i + 1, j) to (i, j + 1)
    kTwoDown,
    kStripSpringCount
};

// How often a sweep projects the springs of a kind. Those down to the next row once more after the row above, which has
// stretched them again: cloth mostly hangs from its first row, and on these.
inline constexpr std::array<int, kStripSpringCount> kStripPasses{1, 1, 2, 1, 1, 1};

// Linear plates that a row owns: C = the sum of coefficient x over its points, pulled to 0. After the springs, in this
// order.
enum StripPlate : int
{
    kPlateAcross,  // x(i) - 2 x(i + 1) + x(i + 2) along the row
    kPlateDown,    // the same along the column
    kPlateTwist,   // x(i, j) - x(i + 1, j) - x(i, j + 1) + x(i + 1, j + 1)
    kStripPlateCount
};

// What all springs of a kind have in common.
struct StripSpringTerms
{
    // Once a lane, which is faster to read than to spread.
    using Lanes = std::array<float, kStrips>;

    bool present = false;
    alignas(64) Lanes rest_length{};   // [m]
    alignas(64) Lanes share{};         // of its excess by which each end moves where both have the sheet's own mass
    alignas(64) Lanes share_length{};  // share * rest_length
    alignas(64) Lanes lightness{};     // of its share that a light projection takes
    alignas(64) Lanes limit_length{};  // where StripSweep::limited: shaders/shared/xpbd.h
    alignas(64) Lanes hardness{};
};

// Shares of both ends, by vector: kStrips of the first end, of the second, then the hardness. Vectors plain_begin ..
// plain_end have the common numbers in every lane, which reads nothing.
inline constexpr int kStripShareFloats = 3 * kStrips;
struct StripShares
{
    const float* lanes;
    int plain_begin, plain_end;
};
struct StripRowShares
{
    std::array<StripShares, kStripSpringCount> springs;
    // By vector: kStrips of every point of a plate, each the way of the point for C = 1, the other way round.
    std::array<const float*, kStripPlateCount> plates;
};

struct StripSweep
{
    float* positions;
    const StripLayout* layout;
    std::array<StripSpringTerms, kStripSpringCount> springs;
    std::array<bool, kStripPlateCount> has_plate;
    bool limited;                       // springs have a limit_length
    const StripRowShares* const* rows;  // one a row
    int lanes;                          // of the vectors that the machine runs: 16, 8 or 4; the result is the same
};

// All springs of rows.end - 1 down to rows.begin, and the exact reverse of that.
void sweep_rows(const StripSweep& sweep, Range rows);
void sweep_rows_back(const StripSweep& sweep, Range rows);

// The springs that join neighbours in these rows, and those that leave them downwards, each lightly: for a soft spring
// less than for a stiff one.
void sweep_lightly(const StripSweep& sweep, Range rows);
void sweep_lightly_back(const StripSweep& sweep, Range rows);

}  // namespace nuno
