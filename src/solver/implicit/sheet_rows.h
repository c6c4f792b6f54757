// How the vertices of a sheet lie in the arrays of the implicit methods.
#pragma once

#include <algorithm>
#include <cstddef>

#include "solver/base/team.h"
#include "solver/implicit/row_fields.h"

namespace nuno {

// Rows of a grid with room around them, so that every neighbour up to two cells away can be read: what is read there is
// 0. A mesh that is no grid lies in rows of kMeshColumns vertices, one after the other.
struct SheetRows
{
    static constexpr int kMargin = 2;

    SheetRows() = default;
    SheetRows(int columns_, int rows_)
        : columns(columns_),
          rows(rows_),
          width((columns_ + kRowLanes - 1) / kRowLanes * kRowLanes),
          stride(width + kRowLanes)
    {
    }

    int columns = 0, rows = 0;
    int width = 0;   // columns rounded up to whole vectors
    int stride = 0;  // from a vertex to the one below it

    std::size_t at(int i, int j) const
    {
        return std::size_t(j + kMargin) * std::size_t(stride) + std::size_t(kRowLanes + i);
    }
    std::size_t size() const { return std::size_t(rows + 2 * kMargin + 1) * std::size_t(stride) + 2 * kRowLanes; }
};

// Calls row(j) for every row of this thread's part. Each row is worked on as a whole, and sums run over the rows in
// order, so that the threads' number changes no bit.
template <class Row>
void for_rows(const SheetRows& rows, const Team& team, const Row& row)
{
    const Range part = team.part(rows.rows);
    for (int j = part.begin; j < part.end; ++j) row(j);
}

// Calls first(j) for every row of this thread's part, and second(j) once first is done for all rows up to `reach` away:
// as soon as may be, while they are in the cache; for those within reach of another thread's part, after it. Returns
// without waiting for the others' second.
template <class First, class Second>
void for_rows_in_turn(const SheetRows& rows, int reach, const Team& team, const First& first, const Second& second)
{
    const Range part = team.part(rows.rows);
    const int begin = part.begin == 0 ? 0 : std::min(part.begin + reach, part.end);
    const int end = std::max(begin, part.end == rows.rows ? part.end : part.end - reach);
    int next = begin;
    for (int j = part.begin; j < part.end; ++j) {
        first(j);
        for (; next < end && next + reach <= j; ++next) second(next);
    }
    for (; next < end; ++next) second(next);
    team.wait();
    for (int j = part.begin; j < begin; ++j) second(j);
    for (int j = end; j < part.end; ++j) second(j);
}

// Damped Jacobi, as all levels are smoothed by it: the share of D^-1 r that a step takes.
constexpr float kJacobiWeight = 0.7f;

}  // namespace nuno
