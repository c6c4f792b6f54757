// The first test of a pair, inlined where pairs come by the million: is there an axis along which it stays apart?
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "collision/ccd/four_points.h"

namespace nuno {

typedef double Double2 __attribute__((vector_size(16)));
typedef std::int64_t Long2 __attribute__((vector_size(16)));  // of a comparison: -1 where it holds, else 0

inline Double2 lesser(Double2 a, Double2 b) { return a < b ? a : b; }
inline Double2 greater(Double2 a, Double2 b) { return a > b ? a : b; }

inline bool any_lane(Long2 mask)
{
#if defined(__SSE2__)
    return _mm_movemask_pd(reinterpret_cast<__m128d>(mask)) != 0;
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

// The coordinates of two axes of one primitive at one time, least and greatest.
struct AxisSpan
{
    Double2 lo, hi;
};

// x and y, or y and z.
inline Double2 two_axes(const glm::dvec3& point, int first_axis)
{
    return first_axis == 0 ? Double2{point.x, point.y} : Double2{point.y, point.z};
}

template <PairKind kind>
inline AxisSpan span_of_first(const FourPoints& points, int axis)
{
    const Double2 a = two_axes(points[0], axis);
    if constexpr (kind == PairKind::vertex_face) return {a, a};
    const Double2 b = two_axes(points[1], axis);
    return {lesser(a, b), greater(a, b)};
}

template <PairKind kind>
inline AxisSpan span_of_second(const FourPoints& points, int axis)
{
    const Double2 b = two_axes(points[2], axis), c = two_axes(points[3], axis);
    const AxisSpan both{lesser(b, c), greater(b, c)};
    if constexpr (kind == PairKind::edge_edge) return both;
    const Double2 a = two_axes(points[1], axis);
    return {lesser(a, both.lo), greater(a, both.hi)};
}

// Whether one axis has the two primitives more than `separation` apart at both times, on the same side, and so at all
// times between. Exact: a rounded difference exceeds the double `separation` only where the difference does.
template <PairKind kind>
inline bool has_axis_gap(const FourPoints& t0, const FourPoints& t1, double separation)
{
    const Double2 least{separation, separation};
    Long2 apart{0, 0};
    for (const int axis : {0, 1}) {
        const AxisSpan first_t0 = span_of_first<kind>(t0, axis), second_t0 = span_of_second<kind>(t0, axis);
        const AxisSpan first_t1 = span_of_first<kind>(t1, axis), second_t1 = span_of_second<kind>(t1, axis);
        const Long2 above = (first_t0.lo - second_t0.hi > least) & (first_t1.lo - second_t1.hi > least);
        const Long2 below = (second_t0.lo - first_t0.hi > least) & (second_t1.lo - first_t1.hi > least);
        apart |= above | below;
    }
    return any_lane(apart);
}

}  // namespace nuno
