// Conservative advancement along directions: each is followed for as long as it shows the separation.
#include <cmath>

#include "collision/ccd/impact.h"
#include "collision/ccd/nearest_direction.h"

namespace nuno {
namespace {

// A pair that would need more is taken for an impact where it has come to.
constexpr int kMostSteps = 10000;

// Above the relative error of a length, or a quotient of two differences.
constexpr double kSafety = 0x1p-48;

// The greatest length is brought near 1 by a power of two, so that no square overflows.
struct ScaledPair
{
    Differences w;
    double separation;
    int exponent = 0;  // 2^exponent times these are the lengths as they were
};

template <PairKind kind>
NUNO_WIDE_INLINE ScaledPair scaled_pair(const FourPoints& t0, const FourPoints& t1, double separation)
{
    ScaledPair pair{differences_of<kind>(t0, t1), separation};
    Differences& w = pair.w;
    const double size = std::max(std::max(w.size[0], w.size[1]), w.size[2]);
    if ((size > 0x1p-40 && size < 0x1p40) || !(size > 0) || !std::isfinite(size)) return pair;
    pair.exponent = std::ilogb(size);
    const double half = std::ldexp(1.0, -pair.exponent / 2);
    const double other_half = std::ldexp(1.0, -pair.exponent - -pair.exponent / 2);
    for (int axis = 0; axis < 3; ++axis) {
        w.t0[axis] = w.t0[axis] * all_lanes4(half) * all_lanes4(other_half);
        w.t1[axis] = w.t1[axis] * all_lanes4(half) * all_lanes4(other_half);
        w.size[axis] = w.size[axis] * half * other_half;
    }
    pair.separation = pair.separation * half * other_half;
    return pair;
}

// The first time at which one of the four linear functions from a to b is no longer above `needed`; 2 where none is.
NUNO_WIDE_INLINE double first_time_below(Double4 a, Double4 b, double needed)
{
    double first = 2;
    for (int i = 0; i < 4; ++i)
        if (b[i] < needed) first = std::min(first, (a[i] - needed) / (a[i] - b[i]) * (1 - kSafety));
    return first;
}

// Along a unit direction d the distance is nowhere below the least d . w_i, and these are linear in time.
template <PairKind kind>
NUNO_WIDE_INLINE std::optional<double> advance(const Differences& w, double separation)
{
    double time = 0;
    for (int step = 0; step < kMostSteps; ++step) {
        Direction at[4];
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k) at[i][k] = (1 - time) * w.t0[k][i] + time * w.t1[k][i];
        const NearestDirection nearest = nearest_direction<kind>(at);
        const double error = direction_error(w, nearest.d);
        if (!(nearest.gap > separation * (1 + kSeparationSlack) + error)) return time;
        const double next =
            first_time_below(along(nearest.d, w.t0), along(nearest.d, w.t1), separation * (1 + kSafety) + error);
        if (next > 1) return std::nullopt;
        if (!(next > time)) return time;
        time = next;
    }
    return time;
}

template <PairKind kind>
NUNO_WIDE_INLINE std::optional<double> separation_impact(const FourPoints& t0, const FourPoints& t1, double separation)
{
    const ScaledPair pair = scaled_pair<kind>(t0, t1, separation);
    if (separates_by_nearest(whole_step(pair.w), pair.w, 3, pair.separation)) return std::nullopt;
    return advance<kind>(pair.w, pair.separation);
}

template <PairKind kind>
double distance_at_least(const FourPoints& points)
{
    const ScaledPair pair = scaled_pair<kind>(points, points, 0);
    Direction w[4];
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) w[i][k] = pair.w.t0[k][i];
    const NearestDirection nearest = nearest_direction<kind>(w);
    const double gap = (nearest.gap - direction_error(pair.w, nearest.d)) * (1 - kSafety);
    return gap > 0 ? std::ldexp(gap, pair.exponent) : 0.0;
}

NUNO_SIMD_CLONES std::optional<double> vertex_face_separation(const FourPoints& t0, const FourPoints& t1,
                                                              double separation)
{
    return separation_impact<PairKind::vertex_face>(t0, t1, separation);
}

NUNO_SIMD_CLONES std::optional<double> edge_edge_separation(const FourPoints& t0, const FourPoints& t1,
                                                            double separation)
{
    return separation_impact<PairKind::edge_edge>(t0, t1, separation);
}

}  // namespace

std::optional<double> impact_of_near_pair(PairKind kind, const FourPoints& t0, const FourPoints& t1, double separation)
{
    if (!(separation > 0)) return impact_of_near_pair(kind, t0, t1);
    return kind == PairKind::vertex_face ? vertex_face_separation(t0, t1, separation)
                                         : edge_edge_separation(t0, t1, separation);
}

double distance_at_least(PairKind kind, const FourPoints& points)
{
    return kind == PairKind::vertex_face ? distance_at_least<PairKind::vertex_face>(points)
                                         : distance_at_least<PairKind::edge_edge>(points);
}

}  // namespace nuno
