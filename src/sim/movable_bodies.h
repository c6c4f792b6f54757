// The bodies of a run, which a hand can move.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "model/body.h"

namespace nuno {

// Numbers of bodies are those of placed_bodies().
class MovableBodies
{
  public:
    // As the scene has them.
    explicit MovableBodies(Bodies bodies);
    MovableBodies(const MovableBodies&) = delete;
    MovableBodies& operator=(const MovableBodies&) = delete;

    const Bodies& bodies() const { return bodies_; }
    // A plane has no end, and stays where it is.
    bool can_move(std::size_t body) const;

    // From the next frame on, until it is let go, a body moves towards this way [m] from where the scene has it, and its
    // group with it. One that cannot move is left alone.
    void hold(std::size_t body, const glm::dvec3& way);
    void release() { held_.reset(); }
    bool is_held() const { return held_.has_value(); }
    // Moves the held one during so many seconds, no faster than a hand, and leaves the others where they are.
    void advance(double start_s, double duration_s);

    // What a hand did to each; empty where it did nothing.
    std::vector<BodyShift> shifts() const;
    // Puts all of them there, and lets go; no shifts: where the scene has them. Error where the number is another.
    void set_shifts(std::span<const BodyShift> shifts);

  private:
    struct Held
    {
        std::size_t body;
        glm::dvec3 way;
    };
    Bodies bodies_;
    std::vector<BodyMotion*> motions_;  // of the bodies in order; in `bodies_`
    std::optional<Held> held_;
};

}  // namespace nuno
