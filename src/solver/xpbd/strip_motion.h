// Start and end of a substep of a sheet in strips: motion without springs, within tethers and out of bodies; then the
// velocity.
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
    glm::vec3 common, last_common;            // [m/s2] of every vertex, in the substep that starts and that ends
    SubstepTimes times;
    std::span<const StripTethers> tethers;
    const float* anchors;                      // [m] positions, kVec3Floats each
    const BodyContacts *bodies, *last_bodies;  // in the substep that starts and that ends; null: none
    float* sticking;  // a lane: 1 where a body holds the vertex at the end; null: not asked for
    int lanes;        // as in StripSweep
};

// The start of a substep; the end of one; and the end of one with the start of the next, which is faster than both.
void predict_rows(const StripMotion& motion, Range rows);
void finish_rows(const StripMotion& motion, Range rows);
void turn_rows(const StripMotion& motion, Range rows);

}  // namespace nuno
