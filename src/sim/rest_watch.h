// When cloth has come to rest, and whether what is around it stands still, so that it can sleep.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "core/archive.h"
#include "model/body.h"
#include "model/sim_params.h"

namespace nuno {

class RestWatch
{
  public:
    // Frames from one look to the next: a look at the device's positions costs a copy.
    static constexpr int kFramesBetween = 5;
    // How long every vertex has to stay where it is [s].
    static constexpr double kRestSeconds = 0.5;

    // Begins anew: something may move the cloth.
    void wake() { places_.clear(); }
    // Looks at positions xyz [m] at a time [s]: all within `most_motion` [m] of a former place for kRestSeconds is rest.
    // 0 is never.
    void look(std::span<const glm::vec4> positions, double time_s, float most_motion);
    // Writes all of it, or reads it.
    void carry(Archive& archive);
    bool is_at_rest() const { return !places_.empty() && at_rest_; }

  private:
    std::vector<glm::vec4> places_;  // that no vertex has left since
    double since_s_ = 0;
    bool at_rest_ = false;
};

// Whether bodies, handles or the wind change between two times [s].
bool surroundings_change(const SimParams& params, const Bodies& bodies, double from_s, double to_s);

}  // namespace nuno
