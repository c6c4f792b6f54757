// Long-range attachments: how far along the cloth every vertex is from the vertices that hold it.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// The vertex may not be further from `anchor` than `length` [m]: the geodesic distance on the sheet at rest.
struct Tether
{
    static constexpr std::uint32_t kNone = ~0u;

    std::uint32_t anchor = kNone;  // vertex of the model
    float length = std::numeric_limits<float>::max();
};

// One group of anchors joined by edges counts as one support: two tethers to neighbours in a pinned row would be one.
constexpr int kTethersPerVertex = 2;

// True where the straight line between any two points of the sheet at rest lies in it: flat, with one convex rim.
bool is_flat_and_convex(const ClothModel& model, const Sheet& sheet);

// Distances along one sheet at rest; exact where it is flat and convex, else by fast marching over its faces.
class SheetGeodesics
{
  public:
    // `model` and `sheet` must outlive it.
    SheetGeodesics(const ClothModel& model, const Sheet& sheet);

    // Tether k of vertex v of the sheet is at k * vertex_count + v - first_vertex: to the nearest anchors of the two
    // nearest groups, in the order of the groups, so that neighbours have like tethers in one slot. `held`: one a
    // vertex of the model, not 0 where it is an anchor. Anchors themselves have none.
    std::vector<Tether> pin_tethers(std::span<const std::uint8_t> held) const;

    // The nearest anchor of every vertex and the way to it, the same for all groups.
    std::vector<Tether> nearest(std::span<const std::uint32_t> anchors) const;

  private:
    void march(std::span<const std::uint32_t> anchors, std::vector<Tether>& nearest) const;
    void spread(std::span<const std::uint32_t> anchors, std::vector<Tether>& nearest) const;
    std::vector<std::vector<std::uint32_t>> groups(std::span<const std::uint8_t> held) const;

    const ClothModel& model_;
    const Sheet& sheet_;
    std::span<const glm::uvec3> faces_;
    bool straight_;
    // Faces around vertex v of the sheet: around_[first_around_[v]] .. [first_around_[v + 1]).
    std::vector<std::uint32_t> first_around_, around_;
};

}  // namespace nuno
