// The poses of all bodies and moving pins over the substeps of one call, as solvers read them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/body.h"
#include "model/cloth_model.h"

namespace nuno {

// One body during one substep h, rounded to float once for both backends.
struct BodyStep
{
    glm::vec4 position;     // [m] at the end; w: radius, of a box or mesh that of a ball around all of it
    glm::vec4 axis[3];      // its own axes in the world at the end; w: half size along each
    glm::vec4 origin;       // [m] its position at the start; w: where its grid begins, in headers of grid_numbers()
    glm::vec4 velocity[3];  // rows: that of the point at x [m/s] is w + xyz . (x - origin), its way over h
};

// Where a moving pin is at the end of a substep.
struct PinStep
{
    glm::vec4 position;  // [m]
    glm::vec4 velocity;  // [m/s] its way in the substep over h
};

class BodySteps
{
  public:
    // `bodies` and `model` must outlive it.
    BodySteps(const Bodies& bodies, const ClothModel& model);

    // Fills the substeps from `start_time_s` on, each `h` s long. Bodies of which none moves are filled once only, until
    // one does.
    void plan(double start_time_s, double h, int substep_count);

    // All grids of meshes one after another: a header of origin, cell [m], 1 / cell and number of cells along the axes,
    // then the values, up to whole headers so that the start of each is exact as a float. Read in one piece by kernels.
    static constexpr std::size_t kGridHeader = 8;
    std::vector<float> grid_numbers() const;
    const DistanceGrid* grid(std::size_t body) const { return placed_[body].grid; }

    // Radius [m] of a ball around a body's position that holds all of it; infinite for a plane.
    float bound(std::size_t body) const { return bounds_[body]; }

    std::size_t body_count() const { return placed_.size(); }
    std::span<const HandlePin> pins() const { return model_.handle_pins; }
    // Number of the first entry of a substep in all_bodies() and all_pins().
    std::size_t first_body(int substep) const { return moves_ ? std::size_t(substep) * placed_.size() : 0; }
    std::size_t first_pin(int substep) const { return std::size_t(substep) * pins().size(); }
    std::span<const BodyStep> bodies(int substep) const
    {
        return std::span(body_steps_).subspan(first_body(substep), placed_.size());
    }
    std::span<const PinStep> pin_steps(int substep) const
    {
        return std::span(pin_steps_).subspan(first_pin(substep), pins().size());
    }
    const std::vector<BodyStep>& all_bodies() const { return body_steps_; }
    const std::vector<PinStep>& all_pins() const { return pin_steps_; }

  private:
    void plan_pins(double start_time_s, double h, int substep_count);

    const std::vector<Handle>& handles_;
    const ClothModel& model_;
    std::vector<PlacedBody> placed_;
    std::vector<float> grid_starts_, bounds_;
    std::vector<BodyStep> body_steps_;
    std::vector<PinStep> pin_steps_;
    bool moves_ = false;  // of what is filled
};

}  // namespace nuno
