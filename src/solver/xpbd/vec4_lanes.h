// Vectors of x, y and z from places scattered among positions of four floats each, and back: whole positions are read
// and turned over in registers, which is several times as fast as picking single floats.
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>

#include "model/formulas.h"

namespace nuno {

// kLaneCount positions x, y, z and what stands in their fourth place.
template <int kLaneCount>
struct WideVec4
{
    WideVec<kLaneCount> xyz;
    Wide<kLaneCount> w;
};

template <int kLaneCount>
struct Vec4Lanes
{
    using Lanes = typename Wide<kLaneCount>::Lanes;
    template <int kCount>
    using LanesOf = typename Wide<kCount>::Lanes;

    // Lane 0 is the position at positions + index[0], and so on.
    static NUNO_WIDE_INLINE WideVec4<kLaneCount> load(const float* positions, const std::uint32_t* index)
    {
        return turned(rows<kLaneCount, 0>(positions, index), rows<kLaneCount, 1>(positions, index),
                      rows<kLaneCount, 2>(positions, index), rows<kLaneCount, 3>(positions, index));
    }
    // The positions of a run, vertex r of it in lane run_lane(kLaneCount, r).
    static NUNO_WIDE_INLINE WideVec4<kLaneCount> load_run(const float* positions)
    {
        Lanes row[4];
        std::memcpy(row, positions, sizeof row);
        return turned(row[0], row[1], row[2], row[3]);
    }
    static NUNO_WIDE_INLINE void store_run(float* positions, const WideVec4<kLaneCount>& a)
    {
        const WideVec4<kLaneCount> back = turned(a.xyz.x.lanes, a.xyz.y.lanes, a.xyz.z.lanes, a.w.lanes);
        const Lanes row[4] = {back.xyz.x.lanes, back.xyz.y.lanes, back.xyz.z.lanes, back.w.lanes};
        std::memcpy(positions, row, sizeof row);
    }

    // No place may be named twice.
    static NUNO_WIDE_INLINE void store(float* positions, const std::uint32_t* index, const WideVec4<kLaneCount>& a)
    {
        const WideVec4<kLaneCount> back = turned(a.xyz.x.lanes, a.xyz.y.lanes, a.xyz.z.lanes, a.w.lanes);
        put<kLaneCount, 0>(positions, index, back.xyz.x.lanes);
        put<kLaneCount, 1>(positions, index, back.xyz.y.lanes);
        put<kLaneCount, 2>(positions, index, back.xyz.z.lanes);
        put<kLaneCount, 3>(positions, index, back.w.lanes);
    }

  private:
    // Groups of four lanes side by side: position kRow of every group of four.
    template <int kCount, int kRow>
    static NUNO_WIDE_INLINE LanesOf<kCount> rows(const float* positions, const std::uint32_t* index)
    {
        if constexpr (kCount == 4) {
            LanesOf<4> row;
            std::memcpy(&row, positions + index[kRow], sizeof row);
            return row;
        } else {
            return joined(rows<kCount / 2, kRow>(positions, index),
                          rows<kCount / 2, kRow>(positions, index + kCount / 2), std::make_index_sequence<kCount>{});
        }
    }
    template <int kCount, int kRow>
    static NUNO_WIDE_INLINE void put(float* positions, const std::uint32_t* index, const LanesOf<kCount>& row)
    {
        if constexpr (kCount == 4) {
            std::memcpy(positions + index[kRow], &row, sizeof row);
        } else {
            put<kCount / 2, kRow>(positions, index, half<0>(row, std::make_index_sequence<kCount / 2>{}));
            put<kCount / 2, kRow>(positions, index + kCount / 2, half<1>(row, std::make_index_sequence<kCount / 2>{}));
        }
    }
    template <class Half, std::size_t... kLane>
    static NUNO_WIDE_INLINE LanesOf<int(sizeof...(kLane))> joined(const Half& low, const Half& high,
                                                                  std::index_sequence<kLane...>)
    {
        return __builtin_shufflevector(low, high, int(kLane)...);
    }
    template <int kWhich, class Whole, std::size_t... kLane>
    static NUNO_WIDE_INLINE LanesOf<int(sizeof...(kLane))> half(const Whole& whole, std::index_sequence<kLane...>)
    {
        return __builtin_shufflevector(whole, whole, int(kLane + kWhich * sizeof...(kLane))...);
    }

    // Lanes kFirst and kFirst + 1 of both, in turns, in every group of four; and pairs kFirst / 2 of both.
    template <int kFirst, std::size_t... kLane>
    static NUNO_WIDE_INLINE Lanes in_turns(const Lanes& a, const Lanes& b, std::index_sequence<kLane...>)
    {
        return __builtin_shufflevector(a, b,
                                       int(kLane / 4 * 4 + kFirst + kLane % 4 / 2 + (kLane % 2 ? kLaneCount : 0))...);
    }
    template <int kFirst, std::size_t... kLane>
    static NUNO_WIDE_INLINE Lanes pairs(const Lanes& a, const Lanes& b, std::index_sequence<kLane...>)
    {
        return __builtin_shufflevector(a, b,
                                       int(kLane / 4 * 4 + kFirst + kLane % 2 + (kLane % 4 / 2 ? kLaneCount : 0))...);
    }
    // The 4 x 4 transpose of every group of four lanes.
    static NUNO_WIDE_INLINE WideVec4<kLaneCount> turned(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d)
    {
        using Real = Wide<kLaneCount>;
        constexpr auto all = std::make_index_sequence<kLaneCount>{};
        const Lanes ab_low = in_turns<0>(a, b, all), cd_low = in_turns<0>(c, d, all);
        const Lanes ab_high = in_turns<2>(a, b, all), cd_high = in_turns<2>(c, d, all);
        return {{Real(pairs<0>(ab_low, cd_low, all)), Real(pairs<2>(ab_low, cd_low, all)),
                 Real(pairs<0>(ab_high, cd_high, all))},
                Real(pairs<2>(ab_high, cd_high, all))};
    }
};

}  // namespace nuno
