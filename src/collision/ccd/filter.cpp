// Halves the step until each piece has no contact, or one that is bracketed. The same bits on every instruction set.
#include "collision/ccd/filter.h"

#include "collision/ccd/separating_direction.h"

namespace nuno {
namespace {

constexpr int kMostHalvings = 6, kShortestCount = 1 << kMostHalvings;

// Within these the products of three differences neither overflow nor lose their error bound to underflow.
constexpr double kLeastSize = 1e-70, kGreatestSize = 1e70;

// Half the width of the widest bracket that is an answer.
constexpr double kWidestBracket = 4.9e-10;

// No difference along an axis is exact too.
NUNO_WIDE_INLINE bool has_range_of_filter(const Differences& w)
{
    for (const double size : w.size)
        if (!(size == 0 || (size >= kLeastSize && size <= kGreatestSize))) return false;
    return true;
}

// Exactly one root, by the rule of signs: +, +, any, - or +, any, -, -, and so with the signs turned.
NUNO_WIDE_INLINE bool has_one_root(const VolumeCubic& f)
{
    const int begin = f.sign(0), end = f.sign(3);
    return begin * end < 0 && (f.sign(1) == begin || f.sign(2) == end);
}

NUNO_WIDE_INLINE bool has_no_root(const VolumeCubic& f)
{
    const int begin = f.sign(0);
    return begin != 0 && f.sign(1) == begin && f.sign(2) == begin && f.sign(3) == begin;
}

struct RootGuess
{
    double place;  // in [0, 1] over the piece
    double slope;  // magnitude
};

// Newton, kept between the ends of the sign change.
NUNO_WIDE_INLINE RootGuess guess_root(const VolumeCubic& f)
{
    const double c0 = f.b[0], c1 = f.b[1] - 3 * c0, c2 = f.b[2] - 2 * f.b[1] + 3 * c0;
    const double c3 = f.b[3] - f.b[2] + f.b[1] - c0;
    const auto slope_at = [=](double s) NUNO_WIDE_LAMBDA { return (3 * c3 * s + 2 * c2) * s + c1; };
    double lo = 0, hi = 1, s = c0 / (c0 - f.b[3]);
    for (int step = 0; step < 60; ++step) {
        const double value = ((c3 * s + c2) * s + c1) * s + c0;
        if ((value > 0) == (c0 > 0))
            lo = s;
        else
            hi = s;
        if (std::fabs(value) <= 0.25 * f.error) break;
        double next = s - value / slope_at(s);
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        const double move = std::fabs(next - s);
        s = next;
        if (move < 1e-14 || hi - lo < 1e-15) break;
    }
    return {s, std::fabs(slope_at(s))};
}

// The volume has exactly one root on the piece: brackets it so that the signs at both ends are certain, and decides
// there.
template <PairKind kind>
NUNO_WIDE_INLINE FilterVerdict decide_root(const VolumeCubic& f, const Interval& piece, const Differences& w,
                                           OriginPlace place)
{
    const RootGuess root = guess_root(f);
    const double length = piece.end - piece.begin, middle = piece.begin + root.place * length;
    double half = std::max(2 * f.error / root.slope * length, 2e-15);
    for (int attempt = 0; attempt < 5 && half < kWidestBracket; ++attempt, half *= attempt < 2 ? 8 : 64) {
        const Interval bracket =
            piece_of_step(w, std::max(middle - half, piece.begin), std::min(middle + half, piece.end));
        const VolumeCubic near_root = volume_over(bracket, w);
        if (bracket.begin > piece.begin && near_root.sign(0) != f.sign(0)) continue;
        if (bracket.end < piece.end && near_root.sign(3) != f.sign(3)) continue;
        if (place != OriginPlace::inside) place = place_on<kind>(bracket, w);
        if (place == OriginPlace::inside) return {FilterAnswer::impact, bracket.begin};
        if (place == OriginPlace::outside || is_separated<kind>(bracket, w)) return {FilterAnswer::none, 0};
        return {FilterAnswer::unknown, bracket.begin};
    }
    return {FilterAnswer::unknown, piece.begin};
}

// What one piece tells; `halve` where its halves have to be asked.
struct PieceVerdict
{
    FilterVerdict verdict;
    bool halve;
};

template <PairKind kind>
NUNO_WIDE_INLINE PieceVerdict judge(const Interval& piece, const Differences& w, int halvings)
{
    const PieceVerdict none{{FilterAnswer::none, 0}, false}, halve{{FilterAnswer::unknown, piece.begin}, true};
    const VolumeCubic f = volume_over(piece, w);
    if (has_no_root(f)) return none;
    const OriginPlace place = place_on<kind>(piece, w);
    if (place == OriginPlace::outside) return none;
    if (has_one_root(f)) return {decide_root<kind>(f, piece, w, place), false};
    if (place == OriginPlace::unknown && halvings >= 2 && is_separated<kind>(piece, w)) return none;
    return halve;
}

template <PairKind kind>
NUNO_WIDE_INLINE FilterVerdict filter(const FourPoints& t0, const FourPoints& t1)
{
    const Differences w = differences_of<kind>(t0, t1);
    if (!has_range_of_filter(w)) return {FilterAnswer::unknown, 0};
    const Interval step = whole_step(w);
    if (separates_by_nearest(step, w, 3)) return {FilterAnswer::none, 0};

    // Pieces are walked from the left; `begin` counts in the shortest ones.
    for (int begin = 0, halvings = 0; begin < kShortestCount;) {
        const int count = kShortestCount >> halvings;
        const double from = double(begin) / kShortestCount, to = double(begin + count) / kShortestCount;
        const PieceVerdict piece = judge<kind>(halvings == 0 ? step : piece_of_step(w, from, to), w, halvings);
        if (piece.halve && halvings < kMostHalvings) {
            ++halvings;
            continue;
        }
        if (piece.verdict.answer != FilterAnswer::none) return piece.verdict;
        begin += count;
        while (halvings > 0 && (begin & (kShortestCount >> halvings)) == 0) --halvings;
    }
    return {FilterAnswer::none, 0};
}

}  // namespace

NUNO_SIMD_CLONES FilterVerdict filter_vertex_face(const FourPoints& t0, const FourPoints& t1)
{
    return filter<PairKind::vertex_face>(t0, t1);
}

NUNO_SIMD_CLONES FilterVerdict filter_edge_edge(const FourPoints& t0, const FourPoints& t1)
{
    return filter<PairKind::edge_edge>(t0, t1);
}

}  // namespace nuno
