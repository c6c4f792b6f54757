// A pair as the differences of its points: the primitives touch when the origin lies in the hull of the differences.
#pragma once

#include <algorithm>
#include <cstdint>

#include "collision/ccd/difference_pairs.h"
#include "model/wide.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace nuno {

typedef double Double4 __attribute__((vector_size(32)));
typedef std::int64_t Long4 __attribute__((vector_size(32)));

NUNO_WIDE_INLINE Double4 all_lanes4(double a) { return Double4{a, a, a, a}; }
NUNO_WIDE_INLINE Double4 lesser(Double4 a, Double4 b) { return a < b ? a : b; }
NUNO_WIDE_INLINE Double4 greater(Double4 a, Double4 b) { return a > b ? a : b; }
NUNO_WIDE_INLINE Double4 magnitude(Double4 a)
{
    return reinterpret_cast<Double4>(reinterpret_cast<Long4>(a) & 0x7fffffffffffffff);
}
NUNO_WIDE_INLINE double greatest_lane(Double4 a) { return std::max(std::max(a[0], a[1]), std::max(a[2], a[3])); }
NUNO_WIDE_INLINE double least_lane(Double4 a) { return std::min(std::min(a[0], a[1]), std::min(a[2], a[3])); }

// Bit i is set where lane i of a comparison holds.
NUNO_WIDE_INLINE unsigned lane_bits(Long4 mask)
{
#if defined(__SSE2__)
    const Double4 lanes = reinterpret_cast<Double4>(mask);
    const auto low = __builtin_shufflevector(lanes, lanes, 0, 1), high = __builtin_shufflevector(lanes, lanes, 2, 3);
    return static_cast<unsigned>(_mm_movemask_pd(low) | _mm_movemask_pd(high) << 2);
#else
    return unsigned((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

// Lanes are the four differences (difference_pairs.h), rounded once: each is within 2^-53 of itself.
struct Differences
{
    Double4 t0[3], t1[3];  // by axis
    double size[3];        // by axis: greatest magnitude of the eight
};

template <PairKind kind>
NUNO_WIDE_INLINE Double4 differences_along(const FourPoints& p, int axis)
{
    const double a = p[0][axis], b = p[1][axis], c = p[2][axis], d = p[3][axis];
    if constexpr (kind == PairKind::vertex_face) return Double4{a, a, a, a} - Double4{b, c, d, d};
    return Double4{a, b, a, b} - Double4{c, c, d, d};
}

template <PairKind kind>
NUNO_WIDE_INLINE Differences differences_of(const FourPoints& t0, const FourPoints& t1)
{
    Differences w;
    for (int axis = 0; axis < 3; ++axis) {
        w.t0[axis] = differences_along<kind>(t0, axis);
        w.t1[axis] = differences_along<kind>(t1, axis);
        w.size[axis] = greatest_lane(greater(magnitude(w.t0[axis]), magnitude(w.t1[axis])));
    }
    return w;
}

}  // namespace nuno
