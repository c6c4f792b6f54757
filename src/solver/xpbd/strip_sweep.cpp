// Sweeps of a sheet in strips, for vectors of 16, 8 and 4 lanes.
#include "solver/xpbd/strip_sweep.h"

#include "solver/xpbd/strip_lanes.h"

namespace nuno {
namespace {

template <int kLaneCount, bool kLimited>
struct Kernel : StripLane<kLaneCount>
{
    using typename StripLane<kLaneCount>::Real;
    using typename StripLane<kLaneCount>::Vec3;
    using typename StripLane<kLaneCount>::Formulas;
    using StripLane<kLaneCount>::load;
    using StripLane<kLaneCount>::store;

    static NUNO_WIDE_INLINE Real excess(const StripSpringTerms& s, const Vec3& d, int lane, const float* hardness)
    {
        const Real rest_length(s.rest_length.data() + lane);
        if constexpr (kLimited)
            return Formulas::limited_excess(d, rest_length, Real(s.limit_length.data() + lane), Real(hardness + lane));
        else
            return Formulas::spring_excess(d, rest_length);
    }

    static NUNO_WIDE_INLINE Real pull(const StripSpringTerms& s, const Vec3& d, int lane)
    {
        const Real share(s.share.data() + lane);
        if constexpr (kLimited)
            return share * excess(s, d, lane, s.hardness.data());
        else
            return Formulas::spring_pull(d, share, Real(s.share_length.data() + lane));
    }

    static NUNO_WIDE_INLINE void project_plain(const StripSpringTerms& s, float* a, float* b)
    {
        for (int lane = 0; lane < kStrips; lane += kLaneCount) {
            const Vec3 xa = load(a + lane), xb = load(b + lane), d = xb - xa;
            const Vec3 move = pull(s, d, lane) * d;
            store(b + lane, xb - move);
            store(a + lane, xa + move);
        }
    }

    static NUNO_WIDE_INLINE void project_shared(const StripSpringTerms& s, float* a, float* b, const float* shares)
    {
        for (int lane = 0; lane < kStrips; lane += kLaneCount) {
            const Vec3 xa = load(a + lane), xb = load(b + lane), d = xb - xa;
            const Real e = excess(s, d, lane, shares + 2 * kStrips);
            // A vector in the next strip ends with the first lane of the vector behind it, unchanged. So it is written
            // first, for that may be a's.
            store(b + lane, xb - (Real(shares + kStrips + lane) * e) * d);
            store(a + lane, xa + (Real(shares + lane) * e) * d);
        }
    }

    template <std::size_t kPoints>
    static NUNO_WIDE_INLINE void project_plate(const std::array<float*, kPoints>& points,
                                               const std::array<float, kPoints>& coefficients, const float* shares)
    {
        for (int lane = 0; lane < kStrips; lane += kLaneCount) {
            std::array<Vec3, kPoints> x;
            for (std::size_t p = 0; p < kPoints; ++p) x[p] = load(points[p] + lane);
            Vec3 c = Real(coefficients[0]) * x[0];
            for (std::size_t p = 1; p < kPoints; ++p) c = c + Real(coefficients[p]) * x[p];
            for (std::size_t p = kPoints; p-- > 0;)  // backwards, for the reason above
                store(points[p] + lane, x[p] - Real(shares + p * kStrips + lane) * c);
        }
    }

    // Vector `column` of a row; past the last one the start of the next strip.
    static NUNO_WIDE_INLINE float* vector_at(float* row, int column, int width)
    {
        return row + (column < width ? column * kVec3Floats : (column - width) * kVec3Floats + 1);
    }

    // The springs of a kind that row a owns at vector c, from vector c + from of row a to c + to of row b.
    static NUNO_WIDE_INLINE void project(const StripSpringTerms& s, const StripShares& shares, float* a, float* b,
                                         int c, int from, int to, int width)
    {
        float* const first = vector_at(a, c + from, width);
        float* const second = vector_at(b, c + to, width);
        if (c >= shares.plain_begin && c < shares.plain_end)
            project_plain(s, first, second);
        else
            project_shared(s, first, second, shares.lanes + c * kStripShareFloats);
    }

    template <bool kBack, class Body>
    static NUNO_WIDE_INLINE void walk(int begin, int end, int step, const Body& body)
    {
        if constexpr (kBack) {
            if (begin < end)
                for (int c = begin + (end - 1 - begin) / step * step; c >= begin; c -= step) body(c);
        } else {
            for (int c = begin; c < end; c += step) body(c);
        }
    }

    template <bool kBack>
    static NUNO_WIDE_INLINE void across(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width;
        const StripSpringTerms& s = sweep.springs[kAcross];
        for (int phase = 0; phase < 2; ++phase)
            walk<kBack>(kBack ? 1 - phase : phase, width, 2,
                        [&](int c) { project(s, shares.springs[kAcross], row, row, c, 0, 1, width); });
    }

    // Vectors 0, 1, 4, 5, 8, .. first, so that neighbours in the order do not wait for one another.
    template <bool kBack>
    static NUNO_WIDE_INLINE void two_across(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width;
        const StripSpringTerms& s = sweep.springs[kTwoAcross];
        for (int phase = 0; phase < 2; ++phase)
            walk<kBack>(kBack ? 2 - 2 * phase : 2 * phase, width, 4, [&](int c) {
                walk<kBack>(c, c + 2 < width ? c + 2 : width, 1,
                            [&](int k) { project(s, shares.springs[kTwoAcross], row, row, k, 0, 2, width); });
            });
    }

    template <bool kBack, StripSpring kSpring, int kFrom, int kTo, int kRows>
    static NUNO_WIDE_INLINE void between(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width;
        const StripSpringTerms& s = sweep.springs[kSpring];
        float* const other = row + kRows * sweep.layout->row_floats;
        walk<kBack>(0, width, 1, [&](int c) { project(s, shares.springs[kSpring], row, other, c, kFrom, kTo, width); });
    }

    template <bool kBack>
    static NUNO_WIDE_INLINE void springs(const StripSweep& sweep, const StripRowShares& shares, float* at, int j)
    {
        const bool one_more = j + 1 < sweep.layout->rows, two_more = j + 2 < sweep.layout->rows;
        const auto part = [&](StripSpring spring) {
            if (!sweep.springs[spring].present) return;
            if (spring == kAcross) across<kBack>(sweep, shares, at);
            if (spring == kTwoAcross) two_across<kBack>(sweep, shares, at);
            if (spring == kDown && one_more) between<kBack, kDown, 0, 0, 1>(sweep, shares, at);
            if (spring == kDownRight && one_more) between<kBack, kDownRight, 0, 1, 1>(sweep, shares, at);
            if (spring == kDownLeft && one_more) between<kBack, kDownLeft, 1, 0, 1>(sweep, shares, at);
            if (spring == kTwoDown && two_more) between<kBack, kTwoDown, 0, 0, 2>(sweep, shares, at);
        };
        for (int k = 0; k < kStripSpringCount; ++k)
            part(static_cast<StripSpring>(kBack ? kStripSpringCount - 1 - k : k));
    }

    template <bool kBack, StripPlate kPlate>
    static NUNO_WIDE_INLINE void plate(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width, stride = sweep.layout->row_floats;
        const float* const table = shares.plates[kPlate];
        const auto at = [&](int rows_on, int c) { return vector_at(row + rows_on * stride, c, width); };
        const auto project_at = [&](int c) {
            if constexpr (kPlate == kPlateAcross)
                project_plate<3>({at(0, c), at(0, c + 1), at(0, c + 2)}, {1, -2, 1}, table + c * 3 * kStrips);
            else if constexpr (kPlate == kPlateDown)
                project_plate<3>({at(0, c), at(1, c), at(2, c)}, {1, -2, 1}, table + c * 3 * kStrips);
            else
                project_plate<4>({at(0, c), at(0, c + 1), at(1, c), at(1, c + 1)}, {1, -1, -1, 1},
                                 table + c * 4 * kStrips);
        };
        // Plates in a row share points: those side by side in the order do not.
        constexpr int phases = kPlate == kPlateAcross ? 3 : kPlate == kPlateTwist ? 2 : 1;
        for (int phase = 0; phase < phases; ++phase)
            walk<kBack>(kBack ? phases - 1 - phase : phase, width, phases, project_at);
    }

    template <bool kBack>
    static NUNO_WIDE_INLINE void plates(const StripSweep& sweep, const StripRowShares& shares, float* at, int j)
    {
        const bool one_more = j + 1 < sweep.layout->rows, two_more = j + 2 < sweep.layout->rows;
        const auto part = [&](int k) {
            if (!sweep.has_plate[std::size_t(k)]) return;
            if (k == kPlateAcross) plate<kBack, kPlateAcross>(sweep, shares, at);
            if (k == kPlateDown && two_more) plate<kBack, kPlateDown>(sweep, shares, at);
            if (k == kPlateTwist && one_more) plate<kBack, kPlateTwist>(sweep, shares, at);
        };
        for (int k = 0; k < kStripPlateCount; ++k) part(kBack ? kStripPlateCount - 1 - k : k);
    }

    template <bool kBack>
    static NUNO_WIDE_INLINE void row(const StripSweep& sweep, int j)
    {
        const StripRowShares& shares = *sweep.rows[j];
        float* const at = sweep.positions + static_cast<std::ptrdiff_t>(j) * sweep.layout->row_floats;
        if constexpr (kBack) plates<kBack>(sweep, shares, at, j);
        springs<kBack>(sweep, shares, at, j);
        if constexpr (!kBack) plates<kBack>(sweep, shares, at, j);
    }

    static NUNO_WIDE_INLINE void rows(const StripSweep& sweep, Range range, bool reverse)
    {
        if (reverse)
            for (int j = range.begin; j < range.end; ++j) row<true>(sweep, j);
        else
            for (int j = range.end - 1; j >= range.begin; --j) row<false>(sweep, j);
    }
};

template <int kLaneCount>
NUNO_WIDE_INLINE void run(const StripSweep& sweep, Range rows, bool reverse)
{
    if (sweep.limited)
        Kernel<kLaneCount, true>::rows(sweep, rows, reverse);
    else
        Kernel<kLaneCount, false>::rows(sweep, rows, reverse);
}

NUNO_BY_LANES(sweep, (const StripSweep& sweep, Range rows), run<kLaneCount>(sweep, rows, false))
NUNO_BY_LANES(back, (const StripSweep& sweep, Range rows), run<kLaneCount>(sweep, rows, true))

}  // namespace

void sweep_rows(const StripSweep& sweep, Range rows) { NUNO_PICK_LANES(sweep, sweep.lanes)(sweep, rows); }
void sweep_rows_back(const StripSweep& sweep, Range rows) { NUNO_PICK_LANES(back, sweep.lanes)(sweep, rows); }

}  // namespace nuno
