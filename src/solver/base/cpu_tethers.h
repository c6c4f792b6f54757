// The tethers of all sheets to vertices that are held, as solvers in lanes read them.
#pragma once

#include <cstdint>
#include <vector>

#include "model/formulas.h"
#include "solver/base/pin_tethers.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

// Tether k of a place is at k * stride + place.
struct TetherLanes
{
    const std::uint32_t* anchors;  // null: no tethers
    const float* lengths;          // [m]
    std::int32_t stride;
};

// `to`, but not past the tethers of the places from `first` on; anchors are where x has them.
NUNO_WIDE_INLINE WideVec3 within_tethers(const TetherLanes& tethers, const Lanes3& x, std::int32_t first, WideVec3 to)
{
    if (!tethers.anchors) return to;
    for (int k = 0; k < kTethersPerVertex; ++k) {
        const std::int32_t entry = k * tethers.stride + first;
        to = formulas_wide::tethered(to, gather(x, tethers.anchors + entry), WideFloat(tethers.lengths + entry));
    }
    return to;
}

class CpuTethers
{
  public:
    // `model` must outlive it. `places` by vertex of the model, of `place_count` in all; empty: its own order.
    CpuTethers(const ClothModel& model, std::vector<std::uint32_t> places, std::uint32_t place_count);

    PinTethers& pins() { return pins_; }
    // Finds the tethers anew where what holds them or the parameters have changed.
    void refresh(const SimParams& params);
    TetherLanes lanes() const;

  private:
    PinTethers pins_;
    const std::vector<std::uint32_t> places_;
    const std::size_t vertex_count_, stride_;
    std::vector<std::uint32_t> anchors_;  // the place itself where it has no tether
    std::vector<float> lengths_;
};

}  // namespace nuno
