// The V-cycle over the coarse levels of a grid sheet.
#include "solver/implicit/grid_multigrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/implicit/grid_coarsening.h"

namespace nuno {
namespace {

constexpr int kCoarsestSide = 3;             // at most so many columns and rows, solved directly
constexpr int kLeastVerticesForTeam = 2048;  // one thread works on smaller levels

NUNO_WIDE_INLINE RowVec product_at(const CoarseLevel& a, const Field3& x, std::size_t i)
{
    const RowVec own = row_load(x, i);
    RowVec sum = row_load(a.anchor, i) * own;
    const std::array<std::size_t, kPairCount> steps = pair_steps(a.rows);
#pragma GCC unroll 4
    for (std::size_t link = 0; link < 4; ++link) {
        const std::size_t next = i + steps[link], back = i - steps[link];
        sum = sum + row_load(a.links[link], i) * (own - row_load(x, next));
        sum = sum + row_load(a.links[link], back) * (own - row_load(x, back));
    }
    return sum;
}

NUNO_WIDE_INLINE RowVec far_plate_at(const CoarseLevel& a, const Field3& x, std::size_t i)
{
    const RowVec own = row_load(x, i);
    RowVec sum{};
    const std::array<std::size_t, kPairCount> steps = pair_steps(a.rows);
#pragma GCC unroll 2
    for (std::size_t pair = 4; pair < kPairCount; ++pair) {
        const std::size_t next = i + steps[pair], back = i - steps[pair];
        sum = sum + row_load(a.plate[pair], i) * (own - row_load(x, next));
        sum = sum + row_load(a.plate[pair], back) * (own - row_load(x, back));
    }
    return sum;
}

NUNO_WIDE_INLINE RowVec defect_at(const CoarseLevel& a, const Field3& x, std::size_t i, bool has_plate)
{
    RowVec defect = row_load(a.r, i) - product_at(a, x, i);
    if (has_plate) defect = defect - far_plate_at(a, x, i);
    return defect;
}

NUNO_SIMD_CLONES void residual_row(CoarseLevel& a, bool has_plate, int j)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes)
        row_store(a.t, a.rows.at(i, j), defect_at(a, a.x, a.rows.at(i, j), has_plate));
}

// t = x + w D^-1 (r - A x)
NUNO_SIMD_CLONES void smooth_row(CoarseLevel& a, bool has_plate, int j)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        const RowVec step = row_load(a.inverse_diagonal, place) * defect_at(a, a.x, place, has_plate);
        row_store(a.t, place, row_load(a.x, place) + RowLanes(kJacobiWeight) * step);
    }
}

NUNO_SIMD_CLONES void smooth_row_from_zero(CoarseLevel& a, int j)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        row_store(a.x, place, RowLanes(kJacobiWeight) * (row_load(a.inverse_diagonal, place) * row_load(a.r, place)));
    }
}

NUNO_SIMD_CLONES void invert_row(CoarseLevel& a, bool has_plate, int j)
{
    const std::array<std::size_t, kPairCount> steps = pair_steps(a.rows);
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        RowMatrix sum = row_load(a.anchor, place);
        for (std::size_t link = 0; link < 4; ++link)
            sum = sum + row_load(a.links[link], place) + row_load(a.links[link], place - steps[link]);
        if (has_plate) sum = sum + row_diagonal(row_load(a.plate_diagonal, place));
        row_store(a.inverse_diagonal, place, row_inverse(sum, sum.xx + sum.yy + sum.zz));
    }
}

NUNO_SIMD_CLONES void add_plate_row(CoarseLevel& a, int j)
{
    for (std::size_t link = 0; link < 4; ++link)
        for (const std::size_t e : {0u, 3u, 5u}) {
            Field& to = a.links[link].part[e];
            for (int i = 0; i < a.rows.width; i += kRowLanes) {
                const std::size_t place = a.rows.at(i, j);
                row_store(to, place, row_load(to, place) + row_load(a.plate[link], place));
            }
        }
}

bool small(const CoarseLevel& a) { return a.rows.columns * a.rows.rows < kLeastVerticesForTeam; }

// The plate of a level once coarser: a quarter of the stiffness, alike at the same number of cells from the rim.
void coarsen_plate(const SheetRows& fine, const std::array<Field, kPairCount>& from, CoarseLevel& to)
{
    const int columns = to.rows.columns, rows = to.rows.rows;
    to.plate_diagonal = Field(to.rows.size());
    for (std::size_t pair = 0; pair < kPairCount; ++pair) {
        to.plate[pair] = Field(to.rows.size());
        const PairOffset offset = kPairOffsets[pair];
        for (int j = 0; j + offset.j < rows; ++j)
            for (int i = std::max(-offset.i, 0); i + offset.i < columns && i < columns; ++i) {
                const int fi = 2 * i < columns ? i : i + fine.columns - columns;
                const int fj = 2 * j < rows ? j : j + fine.rows - rows;
                const float w = 0.25f * from[pair][fine.at(fi, fj)];
                to.plate[pair][to.rows.at(i, j)] = w;
                const float more = std::abs(w) - (pair < 4 ? w : 0.0f);
                to.plate_diagonal[to.rows.at(i, j)] += more;
                to.plate_diagonal[to.rows.at(i + offset.i, j + offset.j)] += more;
            }
    }
}

// The coarsest level as one matrix of 3 numbers a vertex, by rows.
std::vector<double> dense_matrix(const CoarseLevel& a)
{
    const int columns = a.rows.columns, rows = a.rows.rows;
    const std::size_t n = 3 * std::size_t(columns * rows);
    std::vector<double> m(n * n, 0.0);
    constexpr std::size_t part[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    const auto add = [&](int from, int to, const Field6& blocks, std::size_t place, double sign) {
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; l < 3; ++l)
                m[(3 * std::size_t(from) + k) * n + 3 * std::size_t(to) + l] +=
                    sign * double(blocks.part[part[k][l]][place]);
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int here = j * columns + i;
            add(here, here, a.anchor, a.rows.at(i, j), 1);
            for (std::size_t link = 0; link < 4; ++link) {
                const int i1 = i + kPairOffsets[link].i, j1 = j + kPairOffsets[link].j;
                if (i1 < 0 || i1 >= columns || j1 >= rows) continue;
                const int there = j1 * columns + i1;
                for (const auto& [from, to] : {std::pair(here, there), std::pair(there, here)}) {
                    add(from, from, a.links[link], a.rows.at(i, j), 1);
                    add(from, to, a.links[link], a.rows.at(i, j), -1);
                }
            }
        }
    return m;
}

// Lower triangle L of m = L L^T, by rows, with 1 / L_ii on the diagonal; 0 there where nothing resists.
std::vector<double> cholesky_factor(std::vector<double> m, std::size_t n)
{
    for (std::size_t i = 0; i < n; ++i) {
        const double least = 1e-12 * m[i * n + i];
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = m[i * n + j];
            for (std::size_t k = 0; k < j; ++k) sum -= m[i * n + k] * m[j * n + k];
            if (j < i)
                m[i * n + j] = sum * m[j * n + j];
            else
                m[i * n + i] = sum > least ? 1 / std::sqrt(sum) : 0;
        }
    }
    return m;
}

void solve_coarsest(const std::vector<double>& factor, std::vector<double>& b, CoarseLevel& a)
{
    const std::size_t n = b.size();
    const auto each = [&](auto body) {
        for (int j = 0; j < a.rows.rows; ++j)
            for (int i = 0; i < a.rows.columns; ++i) body(3 * std::size_t(j * a.rows.columns + i), a.rows.at(i, j));
    };
    each([&](std::size_t k, std::size_t place) {
        b[k] = double(a.r.x[place]);
        b[k + 1] = double(a.r.y[place]);
        b[k + 2] = double(a.r.z[place]);
    });
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k) b[i] -= factor[i * n + k] * b[k];
        b[i] *= factor[i * n + i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= factor[k * n + i] * b[k];
        b[i] *= factor[i * n + i];
    }
    each([&](std::size_t k, std::size_t place) {
        a.x.x[place] = static_cast<float>(b[k]);
        a.x.y[place] = static_cast<float>(b[k + 1]);
        a.x.z[place] = static_cast<float>(b[k + 2]);
    });
}

}  // namespace

CoarseLevel::CoarseLevel(int columns, int rows_)
    : rows(columns, rows_),
      anchor(rows.size()),
      inverse_diagonal(rows.size()),
      x(rows.size()),
      r(rows.size()),
      t(rows.size())
{
    for (Field6& link : links) link = Field6(rows.size());
}

CoarseGrids::CoarseGrids(int columns, int rows)
{
    levels_.emplace_back(columns, rows);
    while (columns > kCoarsestSide || rows > kCoarsestSide) {
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
        levels_.emplace_back(columns, rows);
    }
    const std::size_t unknowns = 3 * std::size_t(columns * rows);
    factor_.resize(unknowns * unknowns);
    solution_.resize(unknowns);
}

void CoarseGrids::set_plate(const SheetRows& above, const std::array<Field, kPairCount>* plate)
{
    has_plate_ = plate != nullptr;
    if (!has_plate_) return;
    coarsen_plate(above, *plate, levels_[0]);
    for (std::size_t k = 1; k < levels_.size(); ++k)
        coarsen_plate(levels_[k - 1].rows, levels_[k - 1].plate, levels_[k]);
}

void CoarseGrids::prepare(const Team& team)
{
    team.wait();
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const bool alone = small(levels_[k]);
        if (alone && !team.leads()) break;
        const Team crew = alone ? Team() : team;
        if (k + 1 < levels_.size()) coarsen_level(levels_[k], levels_[k + 1], crew);
        crew.wait();
        for_rows(levels_[k].rows, crew, [&](int j) {
            if (has_plate_) add_plate_row(levels_[k], j);
        });
        crew.wait();
        for_rows(levels_[k].rows, crew, [&](int j) { invert_row(levels_[k], has_plate_, j); });
        crew.wait();
    }
    if (team.leads()) factor_ = cholesky_factor(dense_matrix(levels_.back()), solution_.size());
    team.wait();
}

void CoarseGrids::solve(const Team& team)
{
    if (!small(levels_.front())) return cycle(0, team);
    if (team.leads()) cycle(0, Team());
    team.wait();
}

void CoarseGrids::cycle(std::size_t level, const Team& team)
{
    CoarseLevel& a = levels_[level];
    if (level + 1 == levels_.size()) {
        solve_coarsest(factor_, solution_, a);
        return;
    }
    for_rows_in_turn(
        a.rows, kGridReach, team, [&](int j) { smooth_row_from_zero(a, j); },
        [&](int j) { residual_row(a, has_plate_, j); });
    team.wait();
    CoarseLevel& next = levels_[level + 1];
    restrict_rows(a.rows, a.t, next.rows, next.r, team);
    team.wait();
    if (!small(next)) {
        cycle(level + 1, team);
    } else {
        if (team.leads()) cycle(level + 1, Team());
        team.wait();
    }
    for_rows_in_turn(
        a.rows, kGridReach, team, [&](int j) { prolong(next.rows, next.x, a.rows, a.x, nullptr, j); },
        [&](int j) { smooth_row(a, has_plate_, j); });
    team.wait();
    if (team.leads()) std::swap(a.x, a.t);
    team.wait();
}

void GridMultigrid::coarsen(const GridMatrix& fine, const Team& team)
{
    coarsen_sheet(fine, coarse_.first(), team);
    coarse_.prepare(team);
}

void GridMultigrid::precondition(const GridMatrix& fine, const Field3& r, Field3& z, Field3& t,
                                 std::span<double> row_dots, const Team& team)
{
    for_rows_in_turn(
        fine.rows, kGridReach, team, [&](int j) { smooth_from_zero(fine, r, t, j); },
        [&](int j) { residual(fine, t, r, z, j); });
    team.wait();
    CoarseLevel& next = coarse_.first();
    restrict_rows(fine.rows, z, next.rows, next.r, team);
    team.wait();
    coarse_.solve(team);
    for_rows_in_turn(
        fine.rows, kGridReach, team, [&](int j) { prolong(next.rows, next.x, fine.rows, t, fine.mass, j); },
        [&](int j) { row_dots[std::size_t(j)] = smooth(fine, t, r, z, j); });
}

}  // namespace nuno
