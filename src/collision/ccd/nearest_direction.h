// The direction from one primitive to the other at one time, and how far apart it shows them to be.
#pragma once

#include "collision/ccd/separating_direction.h"

namespace nuno {

// Of unit length but for rounding. No point of the hull is nearer to the origin than `gap` less rounding.
struct NearestDirection
{
    Direction d;
    double gap;  // least d . w_i; not above 0, or not a number, where there is none
};

NUNO_WIDE_INLINE Direction difference3(const Direction& a, const Direction& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

NUNO_WIDE_INLINE Direction cross3(const Direction& a, const Direction& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Takes out what rounding left of `e` in d.
NUNO_WIDE_INLINE Direction made_orthogonal(const Direction& d, const Direction& e)
{
    const double share = dot3(d, e) / dot3(e, e);
    return {d[0] - share * e[0], d[1] - share * e[1], d[2] - share * e[2]};
}

// d or -d, made a unit.
NUNO_WIDE_INLINE NearestDirection towards_hull(Direction d, const Direction (&w)[4])
{
    const double length = std::sqrt(dot3(d, d)), turned = dot3(d, w[0]) < 0 ? -1 : 1;
    for (double& component : d) component *= turned / length;
    double gap = dot3(d, w[0]);
    for (int i = 1; i < 4; ++i) gap = std::min(gap, dot3(d, w[i]));
    return {d, gap};
}

// The foot of the origin on the segment from a to b.
NUNO_WIDE_INLINE Direction foot_on_segment(const Direction& a, const Direction& b)
{
    const Direction e = difference3(b, a);
    const double share = -dot3(a, e) / dot3(e, e);
    if (!(share > 0)) return a;
    if (share >= 1) return b;
    return made_orthogonal({a[0] + share * e[0], a[1] + share * e[1], a[2] + share * e[2]}, e);
}

// The nearest point of the hull is on a side, at its foot, or inside, where the normal leads to it.
template <PairKind kind>
NUNO_WIDE_INLINE NearestDirection nearest_direction(const Direction (&w)[4])
{
    Direction nearest = w[0];
    for (int side = 0; side < side_count(kind); ++side) {
        const Direction foot = foot_on_segment(w[kSideFrom[row_of(kind)][side]], w[kSideTo[row_of(kind)][side]]);
        if (dot3(foot, foot) < dot3(nearest, nearest)) nearest = foot;
    }
    const NearestDirection by_side = towards_hull(nearest, w);

    const Direction a = difference3(w[1], w[0]), b = made_orthogonal(difference3(w[2], w[0]), a);
    const Direction normal = made_orthogonal(made_orthogonal(cross3(a, b), a), b);
    const NearestDirection by_normal = towards_hull(normal, w);
    return by_normal.gap > by_side.gap || !(by_side.gap > 0) ? by_normal : by_side;
}

}  // namespace nuno
