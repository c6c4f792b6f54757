// Stars in colours, and their projection in batches.
#include "solver/xpbd/star_springs.h"

#include <algorithm>
#include <utility>

#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/vec4_lanes.h"

namespace nuno {
namespace {

// Springs of a ring of kRing vertices in the order of a sweep, in which those that follow one another share no end where
// that can be, so that one need not wait for the other.
template <int kRing>
struct StarOrder
{
    int spring[3 * kRing], a[3 * kRing], b[3 * kRing];

    constexpr StarOrder() : spring{}, a{}, b{}
    {
        int n = 0;
        for (int k = 0; k < kRing; ++k) add(n, k, 0, 1 + k);
        for (const int odd : {0, 1})
            for (int k = odd; k < kRing; k += 2) add(n, kRing + k, 1 + k, 1 + (k + 1) % kRing);
        for (int k = 0; k < kRing; ++k) add(n, 2 * kRing + k, 1 + k, 1 + (k + 2) % kRing);
    }
    constexpr void add(int& n, int which, int from, int to)
    {
        spring[n] = which;
        a[n] = from;
        b[n] = to;
        ++n;
    }
};

template <int kLaneCount, int kRing, bool kBack>
struct StarKernel
{
    using Positions = Vec4Lanes<kLaneCount>;
    using Real = Wide<kLaneCount>;
    using Formulas = WideFormulas<kLaneCount>;
    static constexpr StarOrder<kRing> kOrder{};

    template <int kStep>
    static NUNO_WIDE_INLINE void spring(WideVec4<kLaneCount> (&x)[kRing + 1], const float* numbers)
    {
        constexpr int n = kBack ? 3 * kRing - 1 - kStep : kStep;
        WideVec4<kLaneCount>&a = x[kOrder.a[n]], &b = x[kOrder.b[n]];
        const float* const own = numbers + kOrder.spring[n] * kSpringNumberCount * kColourBatch;
        const WideVec<kLaneCount> d = b.xyz - a.xyz;
        const Real excess = Formulas::spring_excess(d, Real(own + kRestLength * kColourBatch));
        const Real move = Real(own + kSpringShare * kColourBatch) * excess;
        a.xyz = a.xyz + (a.w * move) * d;
        b.xyz = b.xyz - (b.w * move) * d;
    }
    template <std::size_t... kStep>
    static NUNO_WIDE_INLINE void springs(WideVec4<kLaneCount> (&x)[kRing + 1], const float* numbers,
                                         std::index_sequence<kStep...>)
    {
        (spring<int(kStep)>(x, numbers), ...);
    }

    static NUNO_WIDE_INLINE void project(const ConstraintColours& stars, Range batches, float* positions)
    {
        for (int batch = batches.begin; batch < batches.end; ++batch)
            for (int lane = 0; lane < kColourBatch; lane += kLaneCount) {
                const std::uint32_t* const ends = stars.ends(batch) + lane;
                WideVec4<kLaneCount> x[kRing + 1];
                for (int k = 0; k <= kRing; ++k) x[k] = Positions::load(positions, ends + k * kColourBatch);
                springs(x, stars.numbers(batch) + lane, std::make_index_sequence<3 * kRing>{});
                for (int k = 0; k <= kRing; ++k) Positions::store(positions, ends + k * kColourBatch, x[k]);
            }
    }
};

template <int kLaneCount, int kRing>
NUNO_WIDE_INLINE void run(const ConstraintColours& stars, Range batches, bool back, float* positions)
{
    if (back)
        StarKernel<kLaneCount, kRing, true>::project(stars, batches, positions);
    else
        StarKernel<kLaneCount, kRing, false>::project(stars, batches, positions);
}

NUNO_BY_LANES(ring4, (const ConstraintColours& s, Range batches, bool back, float* x),
              (run<kLaneCount, 4>(s, batches, back, x)))
NUNO_BY_LANES(ring5, (const ConstraintColours& s, Range batches, bool back, float* x),
              (run<kLaneCount, 5>(s, batches, back, x)))
NUNO_BY_LANES(ring6, (const ConstraintColours& s, Range batches, bool back, float* x),
              (run<kLaneCount, 6>(s, batches, back, x)))
NUNO_BY_LANES(ring7, (const ConstraintColours& s, Range batches, bool back, float* x),
              (run<kLaneCount, 7>(s, batches, back, x)))

}  // namespace

StarSprings::StarSprings(std::span<const Star> stars, std::size_t spring_count, std::uint32_t vertex_count)
    : places_(spring_count)
{
    const std::vector<std::size_t> colours = colour_stars(stars, vertex_count);
    for (std::size_t size = 0; size < kSizes; ++size) {
        const int ring = static_cast<int>(size) + Stars::kLeastRing;
        std::vector<std::uint32_t> vertices;
        std::vector<std::size_t> own_colours;
        for (std::size_t n = 0; n < stars.size(); ++n) {
            const Star& star = stars[n];
            if (star.ring() != ring) continue;
            for (int k = 0; k < 3 * ring; ++k)
                if (const std::size_t spring = star.springs[std::size_t(k)]; spring != Star::kNoSpring)
                    places_[spring] = {size, own_colours.size(), k, colours[n]};
            vertices.insert(vertices.end(), star.vertices.begin(), star.vertices.end());
            own_colours.push_back(colours[n]);
        }
        // Those of one colour are apart, so that each gets its own as the least that is free.
        sizes_[size].emplace(vertices, ring + 1, 3 * ring * kSpringNumberCount, vertex_count, own_colours);
        colour_count_ = std::max(colour_count_, sizes_[size]->colour_count());
    }
}

std::size_t StarSprings::colour(std::size_t spring) const { return places_[spring].colour; }

void StarSprings::set_numbers(std::size_t spring, float rest_length, float share)
{
    const Place& at = places_[spring];
    ConstraintColours& numbers = *sizes_[at.size];
    numbers.number(at.star, at.spring * kSpringNumberCount + kRestLength) = rest_length;
    numbers.number(at.star, at.spring * kSpringNumberCount + kSpringShare) = share;
}

void StarSprings::project(int colour, bool back, float* positions, int lanes, const Team& team) const
{
    for (std::size_t size = 0; size < kSizes; ++size) {
        const ConstraintColours& stars = *sizes_[size];
        if (colour >= stars.colour_count()) continue;
        const Range batches = team.part(stars.batches(colour));
        switch (static_cast<int>(size) + Stars::kLeastRing) {
        case 4: NUNO_PICK_LANES(ring4, lanes)(stars, batches, back, positions); break;
        case 5: NUNO_PICK_LANES(ring5, lanes)(stars, batches, back, positions); break;
        case 6: NUNO_PICK_LANES(ring6, lanes)(stars, batches, back, positions); break;
        default: NUNO_PICK_LANES(ring7, lanes)(stars, batches, back, positions);
        }
    }
}

}  // namespace nuno
