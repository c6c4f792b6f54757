// How the vertices of a sheet lie in the arrays of the implicit methods, and who works on which rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/thread_pool.h"
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

// The threads that work on one sheet together. What they compute does not depend on their number: each row is worked on
// as a whole, and sums run over the rows in order.
class Team
{
  public:
    Team(int thread, int thread_count, SpinBarrier* barrier)
        : thread_(thread), thread_count_(thread_count), barrier_(barrier)
    {
    }

    bool leads() const { return thread_ == 0; }
    Range part(int row_count) const { return part_of(row_count, 1, thread_, thread_count_); }
    void wait() const
    {
        if (barrier_) barrier_->arrive_and_wait();
    }
    // Sum of what each row has put in, once all have; no row may be written again before the next wait.
    double sum(std::span<const double> rows) const
    {
        wait();
        double total = 0;
        for (const double row : rows) total += row;
        return total;
    }

  private:
    int thread_, thread_count_;
    SpinBarrier* barrier_;
};

}  // namespace nuno
