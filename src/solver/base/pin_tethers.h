// The tethers of all sheets to vertices that are held, found anew where these or the parameters change.
#pragma once

#include <cstdint>
#include <vector>

#include "model/cloth_state.h"
#include "model/tethers.h"

namespace nuno {

class PinTethers
{
  public:
    // `model` must outlive it.
    explicit PinTethers(const ClothModel& model) : model_(model), held_(model.vertex_count()) {}

    // What is held, in a whole state or where one vertex is placed: what has no inverse mass (w).
    void upload(const ClothState& state);
    void set_vertex(std::uint32_t vertex, const glm::vec4& position);

    // True where the tethers are others than after the call before.
    bool refresh(const SimParams& params);

    bool any() const { return !tethers_.empty(); }
    // Tether k of a vertex of the model is at k * vertex_count + vertex; empty: none.
    const std::vector<Tether>& tethers() const { return tethers_; }

  private:
    const ClothModel& model_;
    std::vector<std::uint8_t> held_;
    bool held_changed_ = true, wanted_ = false;
    float stretch_ = 0;
    std::vector<SheetGeodesics> geodesics_;  // of every sheet, made where tethers first need them
    std::vector<Tether> tethers_;
};

}  // namespace nuno
