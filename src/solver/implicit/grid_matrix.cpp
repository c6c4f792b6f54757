// Products with the matrix of a grid sheet.
#include "solver/implicit/grid_matrix.h"

#include "solver/implicit/row_products.h"

namespace nuno {
namespace {

// What a pair adds to A p at one of its ends: H (p - p_other). `k` is the place of its first end, d and dp are x and p
// of this end less those of the other.
NUNO_WIDE_INLINE RowVec pair_force(const GridMatrix& a, std::size_t pair, std::size_t k, const RowVec& d,
                                   const RowVec& dp)
{
    const RowLanes s = row_load(a.along[pair], k) * row_dot(d, dp);
    return s * d + row_load(a.across[pair], k) * dp;
}

NUNO_WIDE_INLINE RowVec product_at(const GridMatrix& a, const Field3& p, std::size_t i)
{
    const RowVec x = row_load(*a.x, i), own = row_load(p, i);
    RowVec sum = row_load(*a.mass, i) * own;
    const std::array<std::size_t, kPairCount> steps = pair_steps(a.rows);
#pragma GCC unroll 6
    for (std::size_t pair = 0; pair < kPairCount; ++pair) {
        const std::size_t next = i + steps[pair], back = i - steps[pair];
        sum = sum + pair_force(a, pair, i, x - row_load(*a.x, next), own - row_load(p, next));
        sum = sum + pair_force(a, pair, back, x - row_load(*a.x, back), own - row_load(p, back));
    }
    return sum;
}

NUNO_WIDE_INLINE RowMatrix pair_block(const GridMatrix& a, std::size_t pair, std::size_t k, const RowVec& d)
{
    const RowLanes across = row_load(a.across[pair], k);
    return row_outer(d, row_load(a.along[pair], k), max_real(across, -across));
}

}  // namespace

GridMatrix::GridMatrix(const SheetRows& rows_) : rows(rows_), inverse_diagonal(rows.size())
{
    for (Field& field : along) field = Field(rows.size());
    for (Field& field : across) field = Field(rows.size());
    for (Field& field : plate) field = Field(rows.size());
}

NUNO_SIMD_CLONES void invert_diagonal(GridMatrix& a, int row)
{
    const std::array<std::size_t, kPairCount> steps = pair_steps(a.rows);
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, row);
        const RowVec x = row_load(*a.x, place);
        const RowLanes mass = row_load(*a.mass, place);
        RowMatrix sum = row_diagonal(mass);
#pragma GCC unroll 6
        for (std::size_t pair = 0; pair < kPairCount; ++pair) {
            const std::size_t next = place + steps[pair], back = place - steps[pair];
            sum = sum + pair_block(a, pair, place, x - row_load(*a.x, next));
            sum = sum + pair_block(a, pair, back, x - row_load(*a.x, back));
        }
        row_store(a.inverse_diagonal, place, row_inverse(sum, mass));
    }
}

NUNO_SIMD_CLONES double apply(const GridMatrix& a, const Field3& p, Field3& q, int row)
{
    return apply_row(a.rows, *a.mass, p, q, row,
                     [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, p, place); });
}

NUNO_SIMD_CLONES void residual(const GridMatrix& a, const Field3& x, const Field3& r, Field3& t, int row)
{
    defect_row(a.rows, *a.mass, r, t, row, [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, x, place); });
}

NUNO_SIMD_CLONES double smooth(const GridMatrix& a, const Field3& x, const Field3& r, Field3& z, int row)
{
    return smooth_row(a.rows, a.inverse_diagonal, x, r, z, row,
                      [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, x, place); });
}

NUNO_SIMD_CLONES void smooth_from_zero(const GridMatrix& a, const Field3& r, Field3& z, int row)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, row);
        row_store(z, place, RowLanes(kJacobiWeight) * (row_load(a.inverse_diagonal, place) * row_load(r, place)));
    }
}

}  // namespace nuno
