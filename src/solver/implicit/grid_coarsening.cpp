// From one level of a grid to the next coarser one.
#include "solver/implicit/grid_coarsening.h"

#include <algorithm>
#include <array>
#include <utility>

namespace nuno {
namespace {

// One row of the level above, summed over the rows that a coarse row stands for, with room before and after.
class RowSum
{
  public:
    explicit RowSum(const SheetRows& rows) : values_(std::size_t(rows.width + 3 * kRowLanes)) {}
    void clear() { std::fill(values_.begin(), values_.end(), 0.0f); }
    float* data() { return values_.data() + kRowLanes; }

  private:
    std::vector<float> values_;
};

struct RowSums
{
    explicit RowSums(const SheetRows& rows)
        : right(6, RowSum(rows)),
          two_right(6, RowSum(rows)),
          below(6, RowSum(rows)),
          down(6, RowSum(rows)),
          up(6, RowSum(rows)),
          anchor(6, RowSum(rows))
    {
    }
    void clear()
    {
        for (auto* sums : {&right, &two_right, &below, &down, &up, &anchor})
            for (RowSum& sum : *sums) sum.clear();
    }
    std::vector<RowSum> right, two_right, below, down, up, anchor;  // six entries each
};

// A row that takes part in a coarse row, and its share.
struct RowShare
{
    int row;
    float share;
};

std::array<RowShare, 3> rows_of(int coarse_row, int coarse_rows)
{
    return {{{2 * coarse_row - 1, coarse_row > 0 ? 0.5f : 0.0f},
             {2 * coarse_row, 1.0f},
             {2 * coarse_row + 1, coarse_row + 1 < coarse_rows ? 0.5f : 1.0f}}};
}

NUNO_WIDE_INLINE void add_to(RowSum& sum, int i, const RowLanes& more)
{
    float* to = sum.data() + i;
    (RowLanes(to) + more).store(to);
}

NUNO_WIDE_INLINE void add_to(std::vector<RowSum>& sums, int i, const RowMatrix& m)
{
    const RowLanes parts[6] = {m.xx, m.xy, m.xz, m.yy, m.yz, m.zz};
    for (std::size_t e = 0; e < 6; ++e) add_to(sums[e], i, parts[e]);
}

// Adds `share` times the pairs of a row to `sums`; pairs with a fixed end are anchors (add_anchors), the plate is left
// out.
NUNO_SIMD_CLONES void add_pairs(const GridMatrix& a, std::size_t pair, int row, float share, std::vector<RowSum>& sums)
{
    const PairOffset offset = kPairOffsets[pair];
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, row), next = a.rows.at(i + offset.i, row + offset.j);
        const RowLanes masses = row_load(*a.mass, place) * row_load(*a.mass, next);
        const RowLanes weight = select_positive(masses, RowLanes(share), RowLanes{});
        const RowLanes across = row_load(a.across[pair], place) - row_load(a.plate[pair], place);
        const RowVec d = row_load(*a.x, place) - row_load(*a.x, next);
        add_to(sums, i, row_outer(d, weight * row_load(a.along[pair], place), weight * max_real(across, RowLanes{})));
    }
}

NUNO_SIMD_CLONES void add_masses(const GridMatrix& a, int row, float share, std::vector<RowSum>& sums)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes)
        for (const std::size_t e : {0u, 3u, 5u})
            add_to(sums[e], i, RowLanes(share) * row_load(*a.mass, a.rows.at(i, row)));
}

NUNO_SIMD_CLONES void add_row(const SheetRows& rows, const Field6& from, int row, float share,
                              std::vector<RowSum>& sums)
{
    for (std::size_t e = 0; e < 6; ++e)
        for (int i = 0; i < rows.width; i += kRowLanes)
            add_to(sums[e], i, RowLanes(share) * row_load(from.part[e], rows.at(i, row)));
}

// Sums along a row: what the coarse vertices 0 .. count - 1 stand for; the last takes all of the vertex after it.
NUNO_SIMD_CLONES void gather_columns(const float* __restrict from, float* __restrict to, int count)
{
    for (int i = 0; i < count; ++i) to[i] = from[2 * i] + 0.5f * (from[2 * i - 1] + from[2 * i + 1]);
    to[count - 1] += 0.5f * from[2 * count - 1];
}

NUNO_SIMD_CLONES void gather_right(const float* __restrict one, const float* __restrict two, float* __restrict to,
                                   int count)
{
    for (int i = 0; i < count; ++i)
        to[i] = one[2 * i] + one[2 * i + 1] + two[2 * i] + 0.5f * (two[2 * i - 1] + two[2 * i + 1]);
}

NUNO_SIMD_CLONES void gather_diagonals(const float* __restrict down, const float* __restrict up,
                                       float* __restrict to_down, float* __restrict to_up, int count)
{
    for (int i = 0; i < count; ++i) to_down[i] = down[2 * i] + down[2 * i + 1];
    for (int i = 1; i <= count; ++i) to_up[i] = up[2 * i] + up[2 * i - 1];
}

void gather_row(RowSums& sums, CoarseLevel& coarse, int j)
{
    const int columns = coarse.rows.columns;
    const bool last = j + 1 == coarse.rows.rows;
    const std::size_t place = coarse.rows.at(0, j);
    for (std::size_t e = 0; e < 6; ++e) {
        gather_columns(sums.anchor[e].data(), coarse.anchor.part[e].data() + place, columns);
        gather_right(sums.right[e].data(), sums.two_right[e].data(), coarse.links[0].part[e].data() + place,
                     columns - 1);
        if (last) continue;
        gather_columns(sums.below[e].data(), coarse.links[1].part[e].data() + place, columns);
        gather_diagonals(sums.down[e].data(), sums.up[e].data(), coarse.links[2].part[e].data() + place,
                         coarse.links[3].part[e].data() + place, columns - 1);
    }
}

void coarsen_sheet_row(const GridMatrix& fine, CoarseLevel& coarse, int j, RowSums& sums)
{
    enum : std::size_t
    {
        right,
        below,
        down,
        up,
        two_right,
        two_below
    };
    sums.clear();
    for (const RowShare& r : rows_of(j, coarse.rows.rows)) {
        if (r.share == 0 || r.row >= fine.rows.rows) continue;
        add_masses(fine, r.row, r.share, sums.anchor);
        add_pairs(fine, right, r.row, 0.25f * r.share, sums.right);
        add_pairs(fine, two_right, r.row, r.share, sums.two_right);
        add_pairs(fine, two_below, r.row, r.row == 2 * j ? 1.0f : 0.5f, sums.below);
        if (r.row < 2 * j) continue;
        add_pairs(fine, below, r.row, 0.25f, sums.below);
        add_pairs(fine, down, r.row, 0.25f, sums.down);
        add_pairs(fine, up, r.row, 0.25f, sums.up);
    }
    gather_row(sums, coarse, j);
}

void coarsen_level_row(const CoarseLevel& fine, CoarseLevel& coarse, int j, RowSums& sums)
{
    sums.clear();
    for (const RowShare& r : rows_of(j, coarse.rows.rows)) {
        if (r.share == 0 || r.row >= fine.rows.rows) continue;
        add_row(fine.rows, fine.anchor, r.row, r.share, sums.anchor);
        add_row(fine.rows, fine.links[0], r.row, 0.25f * r.share, sums.right);
        if (r.row < 2 * j) continue;
        add_row(fine.rows, fine.links[1], r.row, 0.25f, sums.below);
        add_row(fine.rows, fine.links[2], r.row, 0.25f, sums.down);
        add_row(fine.rows, fine.links[3], r.row, 0.25f, sums.up);
    }
    gather_row(sums, coarse, j);
}

// The coarse vertices of one that lies between them along one axis, and its shares in them.
struct Parents
{
    int first, second;
    float first_share;
};

Parents parents_of(int i, int coarse_count)
{
    if (i % 2 == 0) return {i / 2, i / 2, 1.0f};
    if (i / 2 + 1 >= coarse_count) return {i / 2, i / 2, 1.0f};
    return {i / 2, i / 2 + 1, 0.5f};
}

void add_anchor(CoarseLevel& coarse, int i, int j, const float (&block)[6])
{
    const Parents column = parents_of(i, coarse.rows.columns), row = parents_of(j, coarse.rows.rows);
    for (const auto& [cj, wj] : {std::pair(row.first, row.first_share), std::pair(row.second, 1 - row.first_share)})
        for (const auto& [ci, wi] :
             {std::pair(column.first, column.first_share), std::pair(column.second, 1 - column.first_share)})
            for (std::size_t e = 0; e < 6; ++e) coarse.anchor.part[e][coarse.rows.at(ci, cj)] += wi * wj * block[e];
}

// A pair with a fixed end holds its other end as an anchor does.
void add_anchors(const GridMatrix& a, CoarseLevel& coarse)
{
    for (const std::size_t place : a.fixed) {
        const int j = int(place / std::size_t(a.rows.stride)) - SheetRows::kMargin;
        const int i = int(place % std::size_t(a.rows.stride)) - kRowLanes;
        for (std::size_t pair = 0; pair < kPairCount; ++pair)
            for (const int side : {1, -1}) {
                const int i1 = i + side * kPairOffsets[pair].i, j1 = j + side * kPairOffsets[pair].j;
                if (i1 < 0 || j1 < 0 || i1 >= a.rows.columns || j1 >= a.rows.rows) continue;
                const std::size_t other = a.rows.at(i1, j1), k = side > 0 ? place : other;
                if ((*a.mass)[other] <= 0) continue;
                const float s = a.along[pair][k], t = std::max(a.across[pair][k], 0.0f);
                const float x = a.x->x[place] - a.x->x[other], y = a.x->y[place] - a.x->y[other],
                            z = a.x->z[place] - a.x->z[other];
                add_anchor(coarse, i1, j1,
                           {s * x * x + t, s * x * y, s * x * z, s * y * y + t, s * y * z, s * z * z + t});
            }
    }
}

NUNO_SIMD_CLONES void restrict_row(const Field& from, const SheetRows& rows, const std::array<RowShare, 3>& shares,
                                   RowSum& sum)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        RowLanes total{};
        for (const RowShare& r : shares) total = total + RowLanes(r.share) * row_load(from, rows.at(i, r.row));
        total.store(sum.data() + i);
    }
}

// to[2 i] += a_i, to[2 i + 1] += (a_i + a_(i+1)) / 2, where a is the mean of two coarse rows; the last hangs on one.
NUNO_SIMD_CLONES void prolong_row(const float* __restrict first, const float* __restrict second, float* __restrict to,
                                  int coarse_columns)
{
    const int last = coarse_columns - 1;
    for (int i = 0; i < last; ++i) {
        const float a = 0.5f * (first[i] + second[i]), b = 0.5f * (first[i + 1] + second[i + 1]);
        to[2 * i] += a;
        to[2 * i + 1] += 0.5f * (a + b);
    }
    const float a = 0.5f * (first[last] + second[last]);
    to[2 * last] += a;
    to[2 * last + 1] += a;
}

// The vertices that are fixed, or past the end of the row, stay 0.
NUNO_SIMD_CLONES void clear_fixed(const float* mass, float* to, int width)
{
    for (int i = 0; i < width; i += kRowLanes)
        select_positive(RowLanes(mass + i), RowLanes(to + i), RowLanes{}).store(to + i);
}

}  // namespace

void coarsen_sheet(const GridMatrix& fine, CoarseLevel& coarse, const Team& team)
{
    RowSums sums(fine.rows);
    for_rows(coarse.rows, team, [&](int j) { coarsen_sheet_row(fine, coarse, j, sums); });
    team.wait();
    if (team.leads()) add_anchors(fine, coarse);
}

void coarsen_level(const CoarseLevel& fine, CoarseLevel& coarse, const Team& team)
{
    RowSums sums(fine.rows);
    for_rows(coarse.rows, team, [&](int j) { coarsen_level_row(fine, coarse, j, sums); });
}

void restrict_rows(const SheetRows& fine_rows, const Field3& fine, const SheetRows& coarse_rows, Field3& coarse,
                   const Team& team)
{
    RowSum sum(fine_rows);
    for_rows(coarse_rows, team, [&](int j) {
        for (const auto& [from, to] : {std::pair(&fine.x, &coarse.x), {&fine.y, &coarse.y}, {&fine.z, &coarse.z}}) {
            restrict_row(*from, fine_rows, rows_of(j, coarse_rows.rows), sum);
            gather_columns(sum.data(), to->data() + coarse_rows.at(0, j), coarse_rows.columns);
        }
    });
}

void prolong(const SheetRows& coarse_rows, const Field3& coarse, const SheetRows& fine_rows, Field3& fine,
             const Field* mass, int row)
{
    const int first = row / 2, second = row % 2 == 0 ? first : std::min(first + 1, coarse_rows.rows - 1);
    for (const auto& [from, to] : {std::pair(&coarse.x, &fine.x), {&coarse.y, &fine.y}, {&coarse.z, &fine.z}}) {
        float* at = to->data() + fine_rows.at(0, row);
        prolong_row(from->data() + coarse_rows.at(0, first), from->data() + coarse_rows.at(0, second), at,
                    coarse_rows.columns);
        if (mass)
            clear_fixed(mass->data() + fine_rows.at(0, row), at, fine_rows.width);
        else if (fine_rows.columns % 2 != 0)
            at[fine_rows.columns] = 0;
    }
}

}  // namespace nuno
