// The tethers of a sheet in strips: laid out by vector, anchors gathered once for all vectors that have the same.
#pragma once

#include <array>
#include <map>

#include "model/distance_transform.h"
#include "model/tethers.h"
#include "solver/xpbd/strip_motion.h"

namespace nuno {

class StripTetherSlots
{
  public:
    void clear();
    // Adds one slot: tether `v - first_vertex` of `tethers` is that of vertex v.
    void add(const StripLayout& layout, const Sheet& sheet, std::span<const Tether> tethers);
    // The slot of contacts, anew: every vertex of the layout's grid is tethered to the nearest one that sticks to a
    // body (a lane of `sticking`), at places of `positions` as they are now. Lengths are multiplied by `stretch`; one
    // that is further away now may stay so: a shorter tether would pull cloth about wherever another vertex begins to
    // stick.
    void set_contacts(const StripLayout& layout, const GridSpacing& spacing, const float* sticking,
                      const float* positions, float stretch);
    // Reads where the anchors are now, but for those of contacts.
    void follow(const float* positions);

    std::span<const StripTethers> slots() const { return slots_; }
    const float* anchors() const { return anchors_.data(); }

  private:
    // Of the anchors of a vector: where their x is among the positions.
    using Places = std::array<std::uint32_t, kStrips>;

    std::vector<StripTethers> slots_;  // that of contacts last
    bool has_contacts_ = false;
    std::map<Places, std::uint32_t> known_;
    std::vector<Places> places_;
    StripLanes anchors_;
};

}  // namespace nuno
