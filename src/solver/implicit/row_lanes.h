// Sixteen numbers side by side in a row of a sheet, vectors and matrices of them. Sums over lanes always run over
// sixteen partial sums, whatever the machine's vectors are, so that the bits are the same everywhere.
#pragma once

#include "model/formulas.h"

namespace nuno {

constexpr int kRowLanes = 16;

using RowLanes = Wide<kRowLanes>;
using RowVec = WideVec<kRowLanes>;

NUNO_WIDE_INLINE RowLanes row_dot(const RowVec& a, const RowVec& b)
{
    return WideFormulas<kRowLanes>::dot_product(a, b);
}

NUNO_WIDE_INLINE double row_sum(const RowLanes& a)
{
    double sum = 0;
    for (int i = 0; i < kRowLanes; ++i) sum += double(a.lanes[i]);
    return sum;
}

struct RowMatrix
{
    RowLanes xx, xy, xz, yy, yz, zz;
};

NUNO_WIDE_INLINE RowVec operator*(const RowMatrix& m, const RowVec& a)
{
    return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
            m.xz * a.x + m.yz * a.y + m.zz * a.z};
}

NUNO_WIDE_INLINE RowMatrix operator+(const RowMatrix& a, const RowMatrix& b)
{
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

NUNO_WIDE_INLINE RowMatrix operator*(const RowLanes& s, const RowMatrix& a)
{
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
}

// t I.
NUNO_WIDE_INLINE RowMatrix row_diagonal(const RowLanes& t)
{
    const RowLanes none{};
    return {t, none, none, t, none, t};
}

// s (d d^T) + t I.
NUNO_WIDE_INLINE RowMatrix row_outer(const RowVec& d, const RowLanes& s, const RowLanes& t)
{
    const RowVec e = s * d;
    return {e.x * d.x + t, e.x * d.y, e.x * d.z, e.y * d.y + t, e.y * d.z, e.z * d.z + t};
}

// Inverse by cofactors of a symmetric, positive definite matrix; 0 where `keep` is not positive. The diagonal is raised
// by a few millionths of the trace, so that rounding leaves it definite however thin the matrix is.
NUNO_WIDE_INLINE RowMatrix row_inverse(const RowMatrix& a, const RowLanes& keep)
{
    const RowLanes one(1.0f), raise(3e-6f);
    const RowLanes unit = one / select_positive(keep, a.xx + a.yy + a.zz, one);
    const RowMatrix m = unit * a;
    const RowLanes xx = m.xx + raise, yy = m.yy + raise, zz = m.zz + raise;
    const RowLanes c0 = yy * zz - m.yz * m.yz, c1 = m.xz * m.yz - m.xy * zz, c2 = m.xy * m.yz - m.xz * yy;
    const RowLanes determinant = max_real(xx * c0 + m.xy * c1 + m.xz * c2, RowLanes(1e-12f));
    const RowLanes scale = select_positive(keep, unit / determinant, RowLanes{});
    return scale * RowMatrix{c0, c1, c2, xx * zz - m.xz * m.xz, m.xy * m.xz - xx * m.yz, xx * yy - m.xy * m.xy};
}

}  // namespace nuno
