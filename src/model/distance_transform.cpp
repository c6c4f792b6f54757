// Exact distance transform, rows first, then columns.
#include "model/distance_transform.h"

#include <cmath>

namespace nuno {
namespace {

// The parabolas f(p) + (x - p)^2 d^2 over a line of points, lowest at each x: f(p) is the square of the distance that p
// already has across the line, infinite where it has none.
class LowerEnvelope
{
  public:
    LowerEnvelope(int count, float spacing)
        : spacing_sq_(double(spacing) * double(spacing)), points_(std::size_t(count)), from_(std::size_t(count) + 1)
    {
    }

    // Calls put(x, p) with the point p whose parabola is lowest at x, for x = 0 .. count - 1.
    template <class Put>
    void run(const std::vector<double>& f, const Put& put)
    {
        const int count = static_cast<int>(f.size());
        int last = -1;
        for (int p = 0; p < count; ++p) {
            if (!std::isfinite(f[std::size_t(p)])) continue;
            double start = 0;
            for (; last >= 0; --last) {
                start = crossing(f, points_[std::size_t(last)], p);
                if (start > from_[std::size_t(last)]) break;
            }
            points_[std::size_t(++last)] = p;
            from_[std::size_t(last)] = last == 0 ? -1.0 : start;
        }
        if (last < 0) return;
        for (int x = 0, k = 0; x < count; ++x) {
            while (k < last && from_[std::size_t(k) + 1] <= x) ++k;
            put(x, points_[std::size_t(k)]);
        }
    }

  private:
    // Where the parabola of q > p becomes the lower one.
    double crossing(const std::vector<double>& f, int p, int q) const
    {
        const double a = f[std::size_t(p)] / spacing_sq_ + double(p) * p,
                     b = f[std::size_t(q)] / spacing_sq_ + double(q) * q;
        return (b - a) / (2.0 * (q - p));
    }

    double spacing_sq_;
    std::vector<int> points_;   // parabolas of the envelope, left to right
    std::vector<double> from_;  // where each begins to be the lowest
};

}  // namespace

std::vector<std::uint32_t> nearest_marked(const GridSpacing& grid, std::span<const std::uint8_t> marked)
{
    const auto columns = std::size_t(grid.columns), rows = std::size_t(grid.rows);
    constexpr double none = INFINITY;
    // Along each row: the nearest marked column.
    std::vector<std::uint32_t> in_row(columns * rows, kNoneMarked);
    for (std::size_t j = 0; j < rows; ++j) {
        std::uint32_t seen = kNoneMarked;
        for (std::uint32_t i = 0; i < columns; ++i) {
            if (marked[j * columns + i]) seen = i;
            in_row[j * columns + i] = seen;
        }
        seen = kNoneMarked;
        for (std::uint32_t i = static_cast<std::uint32_t>(columns); i-- > 0;) {
            if (marked[j * columns + i]) seen = i;
            std::uint32_t& best = in_row[j * columns + i];
            if (best == kNoneMarked || (seen != kNoneMarked && seen - i < i - best)) best = seen;
        }
    }
    std::vector<std::uint32_t> nearest(columns * rows, kNoneMarked);
    LowerEnvelope envelope(grid.rows, grid.dy);
    std::vector<double> f(rows);
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t j = 0; j < rows; ++j) {
            const std::uint32_t at = in_row[j * columns + i];
            const double way = at == kNoneMarked ? none : (double(at) - double(i)) * double(grid.dx);
            f[j] = way * way;
        }
        envelope.run(f, [&](int j, int from) {
            const std::size_t row = std::size_t(from) * columns;
            nearest[std::size_t(j) * columns + i] = static_cast<std::uint32_t>(row) + in_row[row + i];
        });
    }
    return nearest;
}

}  // namespace nuno
