// Start and end of a substep of a sheet in strips: motion without springs, tethers and bodies; then the velocity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "solver/base/cpu_bodies.h"
#include "solver/xpbd/strip_layout.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

// Tethers of every vertex in one slot: vector k of the sheet has the lengths at kStrips k, and the anchors of
// anchor_of[k]; no tether: a length past all others.
struct StripTethers
{
    std::vector<std::uint32_t> anchor_of;
    StripLanes lengths;  // [m]
};

struct StripMotion
{
    const StripLayout* layout;
    float *positions, *velocities;
    float *last_positions, *last_velocities;  // one substep before
    float* predicted;                         // positions before tethers and springs
    const float* mobility;                    // a lane: inverse mass over that of the sheet; 0 where held
    const float* acceleration;                // [m/s2] beside `common`, as positions are; null: none
    glm::vec3 common;                         // [m/s2] of every vertex
    SubstepTimes times;
    std::span<const StripTethers> tethers;
    const StripTethers* contacts;  // tethers to vertices that stick to bodies; null: none
    const float* anchors;          // [m] positions, kVec3Floats each
    const BodyContacts* bodies;    // null: none
    float* sticking;               // a lane: 1 where a body holds the vertex at the end
    int lanes;                     // as in StripSweep
};

void predict_rows(const StripMotion& motion, Range rows);
void finish_rows(const StripMotion& motion, Range rows);

}  // namespace nuno
