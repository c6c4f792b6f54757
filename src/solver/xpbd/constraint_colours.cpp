// Colours of constraints, and their projection in batches.
#include "solver/xpbd/constraint_colours.h"

#include <algorithm>

#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/first_fit.h"
#include "solver/xpbd/vec4_lanes.h"

namespace nuno {
namespace {

template <int kLaneCount, bool kLimited>
NUNO_WIDE_INLINE void project_some_springs(const ConstraintColours& springs, Range batches, float* positions)
{
    using Positions = Vec4Lanes<kLaneCount>;
    using Real = Wide<kLaneCount>;
    using Formulas = WideFormulas<kLaneCount>;
    for (int batch = batches.begin; batch < batches.end; ++batch)
        for (int lane = 0; lane < kColourBatch; lane += kLaneCount) {
            const std::uint32_t* const a = springs.ends(batch) + lane;
            const std::uint32_t* const b = a + kColourBatch;
            const auto number = [&](int n) { return Real(springs.numbers(batch) + n * kColourBatch + lane); };
            WideVec4<kLaneCount> at_a = Positions::load(positions, a), at_b = Positions::load(positions, b);
            const WideVec<kLaneCount> d = at_b.xyz - at_a.xyz;
            Real excess;
            if constexpr (kLimited)
                excess = Formulas::limited_excess(d, number(kRestLength), number(kLimitLength), number(kHardness));
            else
                excess = Formulas::spring_excess(d, number(kRestLength));
            const Real move = number(kSpringShare) * excess;
            at_a.xyz = at_a.xyz + (at_a.w * move) * d;
            at_b.xyz = at_b.xyz - (at_b.w * move) * d;
            Positions::store(positions, a, at_a);
            Positions::store(positions, b, at_b);
        }
}

template <int kLaneCount>
NUNO_WIDE_INLINE void project_some_plates(const ConstraintColours& plates, Range batches, float* positions)
{
    using Positions = Vec4Lanes<kLaneCount>;
    using Real = Wide<kLaneCount>;
    for (int batch = batches.begin; batch < batches.end; ++batch)
        for (int lane = 0; lane < kColourBatch; lane += kLaneCount) {
            const std::uint32_t* const ends = plates.ends(batch) + lane;
            const auto number = [&](int n) { return Real(plates.numbers(batch) + n * kColourBatch + lane); };
            WideVec4<kLaneCount> x[4];
            for (int k = 0; k < 4; ++k) x[k] = Positions::load(positions, ends + k * kColourBatch);
            WideVec<kLaneCount> c = number(0) * x[0].xyz;
            for (int k = 1; k < 4; ++k) c = c + number(k) * x[k].xyz;
            const WideVec<kLaneCount> move = number(kPlateShare) * c;
            for (int k = 0; k < 4; ++k) {
                x[k].xyz = x[k].xyz - (x[k].w * number(k)) * move;
                Positions::store(positions, ends + k * kColourBatch, x[k]);
            }
        }
}

NUNO_BY_LANES(springs, (const ConstraintColours& all, Range batches, float* positions),
              (project_some_springs<kLaneCount, false>(all, batches, positions)))
NUNO_BY_LANES(limited_springs, (const ConstraintColours& all, Range batches, float* positions),
              (project_some_springs<kLaneCount, true>(all, batches, positions)))
NUNO_BY_LANES(plates, (const ConstraintColours& all, Range batches, float* positions),
              project_some_plates<kLaneCount>(all, batches, positions))

}  // namespace

ConstraintColours::ConstraintColours(std::span<const std::uint32_t> vertices, int ends, int number_count,
                                     std::uint32_t vertex_count, std::span<const std::size_t> least_colours)
    : end_count_(ends), number_count_(number_count)
{
    const auto end_count = std::size_t(ends);
    FirstFit fit(vertex_count);
    std::vector<int> counts, colours;
    for (std::size_t first = 0; first < vertices.size(); first += end_count) {
        const std::size_t least = least_colours.empty() ? 0 : least_colours[first / end_count];
        const std::size_t colour = fit.colour(vertices.subspan(first, end_count), least);
        if (counts.size() <= colour) counts.resize(colour + 1);
        ++counts[colour];
        colours.push_back(static_cast<int>(colour));
    }
    first_batch_.push_back(0);
    for (const int count : counts)
        first_batch_.push_back(first_batch_.back() + (count + kColourBatch - 1) / kColourBatch);

    const auto batch_count = std::size_t(first_batch_.back());
    const std::size_t batch_places = end_count * kColourBatch;
    numbers_.assign(batch_count * std::size_t(number_count) * kColourBatch, 0.0f);
    for (std::size_t i = 0; i < batch_count * batch_places; ++i)
        places_.push_back(4 * (vertex_count + static_cast<std::uint32_t>(i % batch_places)));
    std::vector<std::size_t> next;
    for (const int first : first_batch_) next.push_back(std::size_t(first) * kColourBatch);
    for (std::size_t n = 0; n < colours.size(); ++n) {
        const std::size_t slot = next[std::size_t(colours[n])]++;
        slots_.push_back(slot);
        for (std::size_t k = 0; k < end_count; ++k)
            places_[slot / kColourBatch * batch_places + k * kColourBatch + slot % kColourBatch] =
                4 * vertices[n * end_count + k];
    }
}

std::size_t ConstraintColours::colour(std::size_t constraint) const
{
    const auto batch = static_cast<int>(slots_[constraint] / kColourBatch);
    return std::size_t(std::upper_bound(first_batch_.begin(), first_batch_.end(), batch) - first_batch_.begin()) - 1;
}

void project_springs(const ConstraintColours& all, Range batches, bool limited, float* positions, int lanes)
{
    if (limited)
        NUNO_PICK_LANES(limited_springs, lanes)(all, batches, positions);
    else
        NUNO_PICK_LANES(springs, lanes)(all, batches, positions);
}

void project_plates(const ConstraintColours& all, Range batches, float* positions, int lanes)
{
    NUNO_PICK_LANES(plates, lanes)(all, batches, positions);
}

}  // namespace nuno
