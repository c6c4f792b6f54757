// Tests of a pair on a piece of the step in double: each says only what is certain in spite of rounding. The bounds are
// derived in docs/ccd.md.
#pragma once

#include <cmath>

#include "collision/ccd/differences.h"

namespace nuno {

constexpr double kUnit = 0x1p-53;  // of rounding to nearest
// Errors of a difference at the end of a piece, a projected area, the volume and a projection, in kUnit times the sizes
// of their factors.
constexpr double kPlaceError = 5, kAreaError = 16, kVolumeError = 48, kDirectionError = 12;

constexpr double kNoUnderflow = 1e-290;  // above what underflow can change a sum of products by

// The differences at the ends of [begin, end].
struct Interval
{
    double begin, end;
    Double4 from[3], to[3];
    double size[3];  // by axis: no less than the magnitudes of those, and of the exact ones
};

NUNO_WIDE_INLINE Interval whole_step(const Differences& w)
{
    Interval piece;
    piece.begin = 0;
    piece.end = 1;
    for (int axis = 0; axis < 3; ++axis) {
        piece.from[axis] = w.t0[axis];
        piece.to[axis] = w.t1[axis];
        piece.size[axis] = w.size[axis] + kPlaceError * kUnit * w.size[axis];
    }
    return piece;
}

NUNO_WIDE_INLINE Interval piece_of_step(const Differences& w, double begin, double end)
{
    Interval piece;
    piece.begin = begin;
    piece.end = end;
    const Double4 a0 = all_lanes4(1 - begin), a1 = all_lanes4(begin), b0 = all_lanes4(1 - end), b1 = all_lanes4(end);
    for (int axis = 0; axis < 3; ++axis) {
        piece.from[axis] = a0 * w.t0[axis] + a1 * w.t1[axis];
        piece.to[axis] = b0 * w.t0[axis] + b1 * w.t1[axis];
        piece.size[axis] = greatest_lane(greater(magnitude(piece.from[axis]), magnitude(piece.to[axis]))) +
                           kPlaceError * kUnit * w.size[axis];
    }
    return piece;
}

// volume(s) = w0 . (w1 x w2) = b0 (1-s)^3 + b1 (1-s)^2 s + b2 (1-s) s^2 + b3 s^3 for s from 0 to 1 over the piece. It
// is 0 at every contact of either kind. b0 and b3 are within `error` of the exact ones, b1 and b2 within 3 `error`.
struct VolumeCubic
{
    double b[4];
    double error;
    int sign(int i) const
    {
        const double least = i == 1 || i == 2 ? 3 * error : error;
        return b[i] > least ? 1 : b[i] < -least ? -1 : 0;
    }
};

NUNO_WIDE_INLINE VolumeCubic volume_over(const Interval& piece, const Differences& w)
{
    // Lanes: w1 and w2 at (from, from), (to, from), (from, to), (to, to).
    Double4 b[3], c[3], at_from = {}, at_to = {};
    for (int k = 0; k < 3; ++k) {
        b[k] = __builtin_shufflevector(piece.from[k], piece.to[k], 1, 5, 1, 5);
        c[k] = __builtin_shufflevector(piece.from[k], piece.to[k], 2, 2, 6, 6);
    }
    for (int k = 0; k < 3; ++k) {
        const int x = k == 2 ? 0 : k + 1, y = k == 0 ? 2 : k - 1;
        const Double4 normal = b[x] * c[y] - b[y] * c[x];
        at_from += all_lanes4(piece.from[k][0]) * normal;
        at_to += all_lanes4(piece.to[k][0]) * normal;
    }
    const double *const m = piece.size, *const all = w.size;
    return {{at_from[0], at_from[1] + at_from[2] + at_to[0], at_to[1] + at_to[2] + at_from[3], at_to[3]},
            kVolumeError * kUnit * (all[0] * m[1] * m[2] + m[0] * all[1] * m[2] + m[0] * m[1] * all[2])};
}

enum class OriginPlace
{
    outside,  // no contact on this piece
    inside,   // contact exactly where the volume is 0
    unknown,
};

// By the areas w_i x w_j seen along an axis, quadratics of time. Face, pairs (0,1)(1,2)(2,0): two of opposite signs put
// the origin outside, three alike inside. Edges, pairs (0,1)(2,3)(0,2)(1,3): the ends of one are on the same side of
// the other where the first two, or the last two, are alike; both of opposite signs are a crossing.
template <PairKind kind>
NUNO_WIDE_INLINE OriginPlace place_from_signs(unsigned positive, unsigned negative)
{
    if constexpr (kind == PairKind::vertex_face) {
        if (positive && negative) return OriginPlace::outside;
        return positive == 15 || negative == 15 ? OriginPlace::inside : OriginPlace::unknown;
    } else {
        if ((positive & positive >> 1 & 5) | (negative & negative >> 1 & 5)) return OriginPlace::outside;
        const unsigned opposite = (positive & negative >> 1) | (negative & positive >> 1);
        return (opposite & 5) == 5 ? OriginPlace::inside : OriginPlace::unknown;
    }
}

template <PairKind kind>
NUNO_WIDE_INLINE Double4 sides_from(Double4 w)
{
    return kind == PairKind::vertex_face ? __builtin_shufflevector(w, w, 0, 1, 2, 2)
                                         : __builtin_shufflevector(w, w, 0, 2, 0, 1);
}
template <PairKind kind>
NUNO_WIDE_INLINE Double4 sides_to(Double4 w)
{
    return kind == PairKind::vertex_face ? __builtin_shufflevector(w, w, 1, 2, 0, 0)
                                         : __builtin_shufflevector(w, w, 1, 3, 2, 3);
}

template <PairKind kind>
NUNO_WIDE_INLINE OriginPlace place_on(const Interval& piece, const Differences& w)
{
    Double4 a0[3], a1[3], b0[3], b1[3];
    for (int k = 0; k < 3; ++k) {
        a0[k] = sides_from<kind>(piece.from[k]);
        a1[k] = sides_from<kind>(piece.to[k]);
        b0[k] = sides_to<kind>(piece.from[k]);
        b1[k] = sides_to<kind>(piece.to[k]);
    }
    OriginPlace place = OriginPlace::unknown;
    for (int k = 0; k < 3; ++k) {
        const int x = k == 2 ? 0 : k + 1, y = k == 0 ? 2 : k - 1;
        const Double4 error = all_lanes4(kAreaError * kUnit * (w.size[x] * piece.size[y] + piece.size[x] * w.size[y]));
        const Double4 q0 = a0[x] * b0[y] - a0[y] * b0[x], q2 = a1[x] * b1[y] - a1[y] * b1[x];
        const Double4 q1 = (a0[x] * b1[y] - a0[y] * b1[x]) + (a1[x] * b0[y] - a1[y] * b0[x]);  // twice the middle one
        const Double4 twice = error + error;
        const OriginPlace seen = place_from_signs<kind>(lane_bits((q0 > error) & (q1 > twice) & (q2 > error)),
                                                        lane_bits((q0 < -error) & (q1 < -twice) & (q2 < -error)));
        if (seen == OriginPlace::outside) return seen;
        if (seen == OriginPlace::inside) place = seen;
    }
    return place;
}

}  // namespace nuno
