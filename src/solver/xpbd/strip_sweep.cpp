// Sweeps of a sheet in strips, for vectors of 16, 8 and 4 lanes.
#include "solver/xpbd/strip_sweep.h"

#include "solver/xpbd/strip_lanes.h"

// Inlined whole, these kernels take the sanitizers' compilers minutes; there they have one instruction set, and may call.
#ifdef NUNO_SANITIZED
#undef NUNO_WIDE_INLINE
#undef NUNO_WIDE_LAMBDA
#define NUNO_WIDE_INLINE inline
#define NUNO_WIDE_LAMBDA
#endif

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

    // kLightly: times the lightness, which is half for stiff springs that a sweep projects once, all for those that it
    // projects twice, and less for soft ones.
    template <bool kLightly>
    static NUNO_WIDE_INLINE void project_plain(const StripSpringTerms& s, float* a, float* b)
    {
        for (int lane = 0; lane < kStrips; lane += kLaneCount) {
            const Vec3 xa = load(a + lane), xb = load(b + lane), d = xb - xa;
            const Real p = pull(s, d, lane);
            const Vec3 move = (kLightly ? Real(s.lightness.data() + lane) * p : p) * d;
            store(b + lane, xb - move);
            store(a + lane, xa + move);
        }
    }

    template <bool kLightly>
    static NUNO_WIDE_INLINE void project_shared(const StripSpringTerms& s, float* a, float* b, const float* shares)
    {
        for (int lane = 0; lane < kStrips; lane += kLaneCount) {
            const Vec3 xa = load(a + lane), xb = load(b + lane), d = xb - xa;
            const Real whole = excess(s, d, lane, shares + 2 * kStrips);
            const Real e = kLightly ? Real(s.lightness.data() + lane) * whole : whole;
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

    // The springs of a kind that a row owns at vector c, which end in these two vectors.
    template <bool kLightly>
    static NUNO_WIDE_INLINE void project(const StripSpringTerms& s, const StripShares& shares, int c, float* first,
                                         float* second)
    {
        if (c >= shares.plain_begin && c < shares.plain_end)
            project_plain<kLightly>(s, first, second);
        else
            project_shared<kLightly>(s, first, second, shares.lanes + c * kStripShareFloats);
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

    template <bool kBack, bool kLightly>
    static NUNO_WIDE_INLINE void across_phase(const StripSweep& sweep, const StripRowShares& shares, float* row,
                                              int first)
    {
        const int width = sweep.layout->width;
        walk<kBack>(first, width, 2, [&](int c) NUNO_WIDE_LAMBDA {
            project<kLightly>(sweep.springs[kAcross], shares.springs[kAcross], c, vector_at(row, c, width),
                              vector_at(row, c + 1, width));
        });
    }

    // Lightly odd vectors, then even ones, then odd ones: without the first, the even springs, which come last in the
    // reverse, would end without an excess and leave the odd ones twice theirs.
    template <bool kBack, bool kLightly>
    static NUNO_WIDE_INLINE void across(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        if constexpr (!kBack) across_phase<kBack, true>(sweep, shares, row, 1);
        if constexpr (kLightly) {
            across_phase<kBack, true>(sweep, shares, row, 0);
        } else {
            for (int phase = 0; phase < 2; ++phase)
                across_phase<kBack, false>(sweep, shares, row, kBack ? 1 - phase : phase);
        }
        if constexpr (kBack) across_phase<kBack, true>(sweep, shares, row, 1);
    }

    // Vectors 0, 1, 4, 5, 8, .. first, so that neighbours in the order do not wait for one another.
    template <bool kBack>
    static NUNO_WIDE_INLINE void two_across(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width;
        const StripSpringTerms& s = sweep.springs[kTwoAcross];
        for (int phase = 0; phase < 2; ++phase)
            walk<kBack>(kBack ? 2 - 2 * phase : 2 * phase, width, 4, [&](int c) NUNO_WIDE_LAMBDA {
                walk<kBack>(c, c + 2 < width ? c + 2 : width, 1, [&](int k) NUNO_WIDE_LAMBDA {
                    project<false>(s, shares.springs[kTwoAcross], k, vector_at(row, k, width),
                                   vector_at(row, k + 2, width));
                });
            });
    }

    template <bool kBack, bool kLightly, StripSpring kSpring, int kFrom, int kTo, int kRows>
    static NUNO_WIDE_INLINE void between(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width;
        const StripSpringTerms& s = sweep.springs[kSpring];
        float* const other = row + kRows * sweep.layout->row_floats;
        walk<kBack>(0, width, 1, [&](int c) NUNO_WIDE_LAMBDA {
            project<kLightly>(s, shares.springs[kSpring], c, vector_at(row, c + kFrom, width),
                              vector_at(other, c + kTo, width));
        });
    }

    // kLightly: all but those over two columns, lightly.
    template <bool kBack, bool kLightly>
    static NUNO_WIDE_INLINE void springs(const StripSweep& sweep, const StripRowShares& shares, float* at, int j)
    {
        const bool one_more = j + 1 < sweep.layout->rows, two_more = j + 2 < sweep.layout->rows;
        const auto part = [&](StripSpring spring) NUNO_WIDE_LAMBDA {
            if (!sweep.springs[spring].present) return;
            if (spring == kAcross) across<kBack, kLightly>(sweep, shares, at);
            if (!kLightly && spring == kTwoAcross) two_across<kBack>(sweep, shares, at);
            if (spring == kDown && one_more) between<kBack, kLightly, kDown, 0, 0, 1>(sweep, shares, at);
            if (spring == kDownRight && one_more) between<kBack, kLightly, kDownRight, 0, 1, 1>(sweep, shares, at);
            if (spring == kDownLeft && one_more) between<kBack, kLightly, kDownLeft, 1, 0, 1>(sweep, shares, at);
            if (spring == kTwoDown && two_more) between<kBack, kLightly, kTwoDown, 0, 0, 2>(sweep, shares, at);
        };
        for (int k = 0; k < kStripSpringCount; ++k)
            part(static_cast<StripSpring>(kBack ? kStripSpringCount - 1 - k : k));
    }

    template <bool kBack, StripPlate kPlate>
    static NUNO_WIDE_INLINE void plate(const StripSweep& sweep, const StripRowShares& shares, float* row)
    {
        const int width = sweep.layout->width, stride = sweep.layout->row_floats;
        const float* const table = shares.plates[kPlate];
        const auto at = [&](int rows_on, int c)
                            NUNO_WIDE_LAMBDA { return vector_at(row + rows_on * stride, c, width); };
        const auto project_at = [&](int c) NUNO_WIDE_LAMBDA {
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
        const auto part = [&](int k) NUNO_WIDE_LAMBDA {
            if (!sweep.has_plate[std::size_t(k)]) return;
            if (k == kPlateAcross) plate<kBack, kPlateAcross>(sweep, shares, at);
            if (k == kPlateDown && two_more) plate<kBack, kPlateDown>(sweep, shares, at);
            if (k == kPlateTwist && one_more) plate<kBack, kPlateTwist>(sweep, shares, at);
        };
        for (int k = 0; k < kStripPlateCount; ++k) part(kBack ? kStripPlateCount - 1 - k : k);
    }

    // The second pass (kStripPasses) of the springs down from the row after row j; and from row 0, which is after none.
    template <bool kBack>
    static NUNO_WIDE_INLINE void down_again(const StripSweep& sweep, float* at, int j)
    {
        const auto down_from = [&](int row) NUNO_WIDE_LAMBDA {
            if (row + 1 >= sweep.layout->rows) return;
            between<kBack, false, kDown, 0, 0, 1>(sweep, *sweep.rows[row], at + (row - j) * sweep.layout->row_floats);
        };
        if (!sweep.springs[kDown].present) return;
        if (kBack && j == 0) down_from(0);
        down_from(j + 1);
        if (!kBack && j == 0) down_from(0);
    }

    template <bool kBack, bool kLightly>
    static NUNO_WIDE_INLINE void row(const StripSweep& sweep, int j)
    {
        const StripRowShares& shares = *sweep.rows[j];
        float* const at = sweep.positions + static_cast<std::ptrdiff_t>(j) * sweep.layout->row_floats;
        if constexpr (kLightly) {
            springs<kBack, true>(sweep, shares, at, j);
        } else if constexpr (kBack) {
            down_again<kBack>(sweep, at, j);
            plates<kBack>(sweep, shares, at, j);
            springs<kBack, false>(sweep, shares, at, j);
        } else {
            springs<kBack, false>(sweep, shares, at, j);
            plates<kBack>(sweep, shares, at, j);
            down_again<kBack>(sweep, at, j);
        }
    }

    template <bool kLightly>
    static NUNO_WIDE_INLINE void rows(const StripSweep& sweep, Range range, bool reverse)
    {
        if (reverse)
            for (int j = range.begin; j < range.end; ++j) row<true, kLightly>(sweep, j);
        else
            for (int j = range.end - 1; j >= range.begin; --j) row<false, kLightly>(sweep, j);
    }
};

template <int kLaneCount, bool kLightly>
NUNO_WIDE_INLINE void run(const StripSweep& sweep, Range rows, bool reverse)
{
    if (sweep.limited)
        Kernel<kLaneCount, true>::template rows<kLightly>(sweep, rows, reverse);
    else
        Kernel<kLaneCount, false>::template rows<kLightly>(sweep, rows, reverse);
}

NUNO_BY_LANES(sweep, (const StripSweep& sweep, Range rows, bool back), (run<kLaneCount, false>(sweep, rows, back)))
NUNO_BY_LANES(lightly, (const StripSweep& sweep, Range rows, bool back), (run<kLaneCount, true>(sweep, rows, back)))

}  // namespace

void sweep_rows(const StripSweep& sweep, Range rows) { NUNO_PICK_LANES(sweep, sweep.lanes)(sweep, rows, false); }
void sweep_rows_back(const StripSweep& sweep, Range rows) { NUNO_PICK_LANES(sweep, sweep.lanes)(sweep, rows, true); }
void sweep_lightly(const StripSweep& sweep, Range rows) { NUNO_PICK_LANES(lightly, sweep.lanes)(sweep, rows, false); }
void sweep_lightly_back(const StripSweep& sweep, Range rows)
{
    NUNO_PICK_LANES(lightly, sweep.lanes)(sweep, rows, true);
}

}  // namespace nuno
