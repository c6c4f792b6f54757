// Looks for a direction along which all differences stay positive over a piece of the step: then the pair stays apart.
#pragma once

#include "collision/ccd/interval.h"

namespace nuno {

using Direction = std::array<double, 3>;

NUNO_WIDE_INLINE double dot3(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

NUNO_WIDE_INLINE double direction_error(const Differences& w, const Direction& d)
{
    return kDirectionError * kUnit *
               (std::fabs(d[0]) * w.size[0] + std::fabs(d[1]) * w.size[1] + std::fabs(d[2]) * w.size[2]) +
           kNoUnderflow;
}

NUNO_WIDE_INLINE Double4 along(const Direction& d, const Double4 (&places)[3])
{
    return all_lanes4(d[0]) * places[0] + all_lanes4(d[1]) * places[1] + all_lanes4(d[2]) * places[2];
}

// d . w_i(t) is linear in t, so that its signs at the ends of the piece are those between.
NUNO_WIDE_INLINE bool separates(const Direction& d, const Interval& piece, const Differences& w)
{
    const Double4 from = along(d, piece.from), to = along(d, piece.to);
    const double error = direction_error(w, d);
    return least_lane(lesser(from, to)) > error || greatest_lane(greater(from, to)) < -error;
}

// Frank-Wolfe towards the point of the hull of the eight that is nearest to the origin, from their mean. Each step goes
// to the best point between where it is and the one that is least along it. With a separation, shows the pair that far
// apart.
NUNO_WIDE_INLINE bool separates_by_nearest(const Interval& piece, const Differences& w, int step_count,
                                           double separation = 0)
{
    Direction d;
    for (int k = 0; k < 3; ++k) {
        const Double4 sum = piece.from[k] + piece.to[k];
        d[k] = 0.125 * ((sum[0] + sum[1]) + (sum[2] + sum[3]));
    }
    for (int step = 0; step < step_count; ++step) {
        const Double4 from = along(d, piece.from), to = along(d, piece.to);
        const double least = least_lane(lesser(from, to));
        const double needed = separation > 0 ? separation * (1 + 0x1p-48) * std::sqrt(dot3(d, d)) : 0.0;
        if (least > needed + direction_error(w, d)) return true;
        const unsigned at_from = lane_bits(from == all_lanes4(least)), at_to = lane_bits(to == all_lanes4(least));
        if (!(at_from | at_to)) return false;
        const int lane = __builtin_ctz(at_from | at_to << 4);
        Direction g;
        for (int k = 0; k < 3; ++k) g[k] = (lane < 4 ? piece.from[k][lane] : piece.to[k][lane - 4]) - d[k];
        const double gg = dot3(g, g);
        if (!(gg > 0)) return false;
        const double share = -dot3(d, g) / gg;
        if (!(share > 0)) return false;
        for (int k = 0; k < 3; ++k) d[k] += std::min(share, 1.0) * g[k];
    }
    return false;
}

// The nearest point to the origin on the sides of the hull, in the middle of the piece.
template <PairKind kind>
NUNO_WIDE_INLINE Direction nearest_side(const Direction (&w)[4])
{
    Direction nearest{};
    double least = INFINITY;
    for (int side = 0; side < side_count(kind); ++side) {
        const Direction &a = w[kSideFrom[row_of(kind)][side]], &b = w[kSideTo[row_of(kind)][side]];
        const Direction e{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double length_sq = dot3(e, e);
        const double s = length_sq > 0 ? std::clamp(-dot3(a, e) / length_sq, 0.0, 1.0) : 0.0;
        const Direction foot{a[0] + s * e[0], a[1] + s * e[1], a[2] + s * e[2]};
        if (dot3(foot, foot) < least) {
            least = dot3(foot, foot);
            nearest = foot;
        }
    }
    return nearest;
}

// More directions than one would try on every piece: towards the nearest point, the nearest side, the normal.
template <PairKind kind>
NUNO_WIDE_INLINE bool is_separated(const Interval& piece, const Differences& w)
{
    if (separates_by_nearest(piece, w, 6)) return true;
    Direction middle[4];
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) middle[i][k] = 0.5 * (piece.from[k][i] + piece.to[k][i]);
    if (separates(nearest_side<kind>(middle), piece, w)) return true;
    Direction a, b;
    for (int k = 0; k < 3; ++k) {
        a[k] = middle[1][k] - middle[0][k];
        b[k] = middle[2][k] - middle[0][k];
    }
    return separates({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}, piece, w);
}

}  // namespace nuno
