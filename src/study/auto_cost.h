// What a frame of a whole scene costs with a setting, over the same frames for every setting: where contact makes frames
// dear only late, those that were cut short would seem cheap.
#pragma once

#include <limits>
#include <string>

#include "study/trajectory.h"

namespace nuno {

struct SceneCost
{
    double ms_per_frame = 0;  // median of all frames, solver and collision; where it is dearer, of those over the limit
    double largest_strain = 0;  // of a thread in any frame
    bool is_dearer = false;     // than the limit: its run ended as soon as that was sure
    std::string failure;        // how it went bad
};

// Runs `frames` frames, one at least. A median over `limit_ms` is known once more than half of all frames took longer.
SceneCost scene_cost(const Scene& scene, const SimParams& params, int frames,
                     double limit_ms = std::numeric_limits<double>::infinity(), const FrameWatch& watch = {});

}  // namespace nuno
