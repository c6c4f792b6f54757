// A vertex of the cloth in a hand.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/cloth_model.h"
#include "model/sim_params.h"
#include "model/tethers.h"

namespace nuno {

constexpr float kHandSpeed = 3.0f;  // of what a hand moves, at most [m/s]

class HeldVertex
{
  public:
    // Takes a vertex where it is [m].
    HeldVertex(const ClothModel& model, const SimParams& params, std::uint32_t vertex, glm::vec3 position);

    std::uint32_t vertex() const { return vertex_; }
    glm::vec3 position() const { return position_; }
    void set_position(glm::vec3 position) { position_ = position; }
    void set_target(glm::vec3 target) { target_ = target; }

    // Moves towards the target, but no faster than a hand; where a thread is taut it goes on across that thread only,
    // as a hand would slide, and it never goes further from a pin than the cloth reaches. `positions` [m]: of the cloth.
    void advance(const ClothModel& model, std::span<const glm::vec4> positions, float duration_s);

  private:
    std::uint32_t vertex_;
    glm::vec3 position_, target_;
    std::vector<Tether> reach_;  // to the nearest pins
};

}  // namespace nuno
