// Sixteen numbers side by side in a row of a sheet, vectors and matrices of them. Sums over lanes always run over
// sixteen partial sums, whatever the machine's vectors are, so that the bits are the same everywhere.
#pragma once

#include <cmath>
#include <cstring>

#include "model/wide.h"

namespace nuno {

constexpr int kRowLanes = 16;

typedef float RowLanes __attribute__((vector_size(kRowLanes * sizeof(float))));

NUNO_WIDE_INLINE RowLanes row_load(const float* from)
{
    RowLanes a;
    std::memcpy(&a, from, sizeof a);
    return a;
}

NUNO_WIDE_INLINE void row_store(float* to, const RowLanes& a) { std::memcpy(to, &a, sizeof a); }

NUNO_WIDE_INLINE RowLanes row_all(float a) { return a - RowLanes{}; }

NUNO_WIDE_INLINE RowLanes row_min(const RowLanes& a, const RowLanes& b) { return a < b ? a : b; }
NUNO_WIDE_INLINE RowLanes row_max(const RowLanes& a, const RowLanes& b) { return a > b ? a : b; }

NUNO_WIDE_INLINE RowLanes row_sqrt(const RowLanes& a)
{
    RowLanes root;
    for (int i = 0; i < kRowLanes; ++i) root[i] = std::sqrt(a[i]);
    return root;
}

NUNO_WIDE_INLINE double row_sum(const RowLanes& a)
{
    double sum = 0;
    for (int i = 0; i < kRowLanes; ++i) sum += double(a[i]);
    return sum;
}

struct RowVec
{
    RowLanes x, y, z;
};

NUNO_WIDE_INLINE RowVec operator+(const RowVec& a, const RowVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
NUNO_WIDE_INLINE RowVec operator-(const RowVec& a, const RowVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
NUNO_WIDE_INLINE RowVec operator*(const RowLanes& s, const RowVec& a) { return {s * a.x, s * a.y, s * a.z}; }
NUNO_WIDE_INLINE RowLanes row_dot(const RowVec& a, const RowVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

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
    const RowLanes unit = row_all(1.0f) / (keep > RowLanes{} ? a.xx + a.yy + a.zz : row_all(1.0f));
    const RowLanes raise = row_all(3e-6f);
    const RowMatrix m = unit * a;
    const RowLanes xx = m.xx + raise, yy = m.yy + raise, zz = m.zz + raise;
    const RowLanes c0 = yy * zz - m.yz * m.yz, c1 = m.xz * m.yz - m.xy * zz, c2 = m.xy * m.yz - m.xz * yy;
    const RowLanes determinant = row_max(xx * c0 + m.xy * c1 + m.xz * c2, row_all(1e-12f));
    const RowLanes scale = keep > RowLanes{} ? unit / determinant : RowLanes{};
    return scale * RowMatrix{c0, c1, c2, xx * zz - m.xz * m.xz, m.xy * m.xz - xx * m.yz, xx * yy - m.xy * m.xy};
}

}  // namespace nuno
