// The matrix of one linear solve on a grid sheet: mass, dampers and springs at the positions of the moment.
#pragma once

#include <array>
#include <vector>

#include "solver/implicit/sheet_rows.h"

namespace nuno {

// Pairs of a grid, each met once: right, below, the two diagonals below, two to the right, two below.
constexpr int kPairCount = 6;

struct PairOffset
{
    int i, j;
};
constexpr std::array<PairOffset, kPairCount> kPairOffsets{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}}};

// The same as steps in a field.
NUNO_WIDE_INLINE std::array<std::size_t, kPairCount> pair_steps(const SheetRows& rows)
{
    const auto stride = std::size_t(rows.stride);
    return {1, stride, stride + 1, stride - 1, 2, 2 * stride};
}

// A = diag(mass) + sum over pairs of H = along d d^T + across I, d = x_b - x_a: the energy
// 1/2 sum mass |p|^2 + 1/2 sum |p_a - p_b|^2_H. Rows and columns of fixed vertices (mass 0) are left out.
struct GridMatrix
{
    explicit GridMatrix(const SheetRows& rows);

    SheetRows rows;
    const Field* mass = nullptr;           // [kg/s2], what the vertex itself resists with; 0: fixed
    const Field3* x = nullptr;             // [m], where the springs were linearised
    std::array<Field, kPairCount> along;   // [N/m3]
    std::array<Field, kPairCount> across;  // [N/m], the plate's share in it
    std::array<Field, kPairCount> plate;   // [N/m], of either sign
    bool has_plate = false;
    Field6 inverse_diagonal;         // of the 3x3 blocks, with |across|, so that damped Jacobi converges
    std::vector<std::size_t> fixed;  // places of fixed vertices, ascending
};

// The functions below are of one row, and read their arguments up to kGridReach rows away.
constexpr int kGridReach = 2;

// Fills inverse_diagonal, from mass, x, along and across.
void invert_diagonal(GridMatrix& a, int row);

// q = A p; returns p . q.
double apply(const GridMatrix& a, const Field3& p, Field3& q, int row);

// t = r - A x; t may be r.
void residual(const GridMatrix& a, const Field3& x, const Field3& r, Field3& t, int row);

// z = x + w D^-1 (r - A x), one step of damped Jacobi; returns r . z.
double smooth(const GridMatrix& a, const Field3& x, const Field3& r, Field3& z, int row);

// z = w D^-1 r, the same from 0.
void smooth_from_zero(const GridMatrix& a, const Field3& r, Field3& z, int row);

}  // namespace nuno
