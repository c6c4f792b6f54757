// Lays tethers out in strips.
#include "solver/xpbd/strip_tethers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kNoTether = 1e18f;  // [m]

glm::vec3 position(const StripLayout& layout, const float* positions, int i, int j)
{
    const float* const at = positions + layout.vec3(i, j);
    return {at[0], at[kStrips], at[2 * kStrips]};
}

}  // namespace

void StripTetherSlots::clear()
{
    slots_.clear();
    has_contacts_ = false;
    known_.clear();
    places_.clear();
}

void StripTetherSlots::add(const StripLayout& layout, const Sheet& sheet, std::span<const Tether> tethers)
{
    std::vector<std::uint32_t> place_of(sheet.vertex_count);
    for (int j = 0; j < layout.rows; ++j)
        for (int i = 0; i < layout.columns; ++i)
            place_of[layout.vertex(sheet, i, j) - sheet.first_vertex] = static_cast<std::uint32_t>(layout.vec3(i, j));

    StripTethers& slot = slots_.emplace_back();
    slot.lengths.assign(layout.lane_floats(), kNoTether);
    bool any = false;
    for (int j = 0; j < layout.rows; ++j)
        for (int c = 0; c < layout.width; ++c) {
            Places places{};
            for (int strip = 0; strip < kStrips; ++strip) {
                const int i = strip * layout.width + c;
                // A lane without a tether takes the anchor of its neighbour, so that vectors are alike.
                places[std::size_t(strip)] = strip > 0 ? places[std::size_t(strip) - 1] : 0;
                if (i >= layout.columns) continue;
                const Tether& tether = tethers[layout.vertex(sheet, i, j) - sheet.first_vertex];
                if (tether.anchor == Tether::kNone) continue;
                any = true;
                slot.lengths[layout.lane(i, j)] = tether.length;
                places[std::size_t(strip)] = place_of[tether.anchor - sheet.first_vertex];
            }
            const auto [at, added] = known_.emplace(places, static_cast<std::uint32_t>(places_.size()));
            if (added) places_.push_back(places);
            slot.anchor_of.push_back(at->second);
        }
    if (!any) slots_.pop_back();
    anchors_.resize(places_.size() * kVec3Floats);
}

void StripTetherSlots::set_contacts(const StripLayout& layout, const GridSpacing& spacing, const float* sticking,
                                    const float* positions, float stretch)
{
    std::vector<std::uint8_t> marked;
    for (int j = 0; j < layout.rows; ++j)
        for (int i = 0; i < layout.columns; ++i) marked.push_back(sticking[layout.lane(i, j)] > 0);
    const std::vector<std::uint32_t> nearest = nearest_marked(spacing, marked);
    const auto first_anchor = static_cast<std::uint32_t>(places_.size());
    if (!has_contacts_) slots_.emplace_back();
    has_contacts_ = true;
    StripTethers& slot = slots_.back();
    slot.anchor_of.clear();
    slot.lengths.assign(layout.lane_floats(), kNoTether);
    anchors_.resize((places_.size() + layout.lane_floats() / kStrips) * kVec3Floats);
    for (int j = 0; j < layout.rows; ++j)
        for (int c = 0; c < layout.width; ++c) {
            slot.anchor_of.push_back(first_anchor + static_cast<std::uint32_t>(slot.anchor_of.size()));
            float* const anchor = anchors_.data() + std::size_t(slot.anchor_of.back()) * kVec3Floats;
            for (int strip = 0; strip < kStrips; ++strip) {
                const int i = strip * layout.width + c;
                if (i >= layout.columns) continue;
                const std::uint32_t n = nearest[std::size_t(j) * std::size_t(layout.columns) + std::size_t(i)];
                if (n == kNoneMarked) continue;
                const int i1 = static_cast<int>(n) % layout.columns, j1 = static_cast<int>(n) / layout.columns;
                if (i1 == i && j1 == j) continue;
                const float along = std::hypot(float(i1 - i) * spacing.dx, float(j1 - j) * spacing.dy) * stretch;
                const glm::vec3 x = position(layout, positions, i, j), at = position(layout, positions, i1, j1);
                slot.lengths[layout.lane(i, j)] = std::max(along, glm::distance(x, at));
                for (int axis = 0; axis < 3; ++axis) anchor[axis * kStrips + strip] = at[axis];
            }
        }
}

void StripTetherSlots::follow(const float* positions)
{
    float* to = anchors_.data();
    for (const Places& places : places_)
        for (int axis = 0; axis < 3; ++axis)
            for (const std::uint32_t place : places) *to++ = positions[place + std::uint32_t(axis * kStrips)];
}

}  // namespace nuno
