// Start and end of a substep of any mesh: motion without springs, tethers and bodies; then the velocity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/cpu_bodies.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

// Vertices in blocks of this many.
inline constexpr int kMeshBlock = 16;

// Where the vertex of a run of lane_count vertices is among lanes, when the whole run is loaded at once.
constexpr std::size_t run_lane(int lane_count, std::size_t vertex)
{
    const auto groups = static_cast<std::size_t>(lane_count) / 4;
    return vertex % groups * 4 + vertex / groups;
}

// Tethers of every vertex in one slot, in runs of MeshMotion::lanes vertices, by lane (run_lane); anchor_of is where its
// anchor begins among MeshMotion::anchors.
struct MeshTethers
{
    std::vector<std::uint32_t> anchor_of;
    std::vector<float> lengths;  // [m]; no tether: past all others
};

// Arrays of four floats a vertex; the fourth of a position is its inverse mass, 0 where held.
struct MeshMotion
{
    float *positions, *velocities;
    float *last_positions, *last_velocities;  // one substep before
    float* predicted;                         // positions before tethers and springs
    const float* acceleration;                // [m/s2] beside `common`; null: none
    glm::vec3 common;                         // [m/s2] of every vertex
    SubstepTimes times;
    std::span<const MeshTethers> tethers;
    const float* anchors;
    const BodyContacts* bodies;  // null: none
    int lanes;                   // 16, 8 or 4; the result is the same
};

void predict_blocks(const MeshMotion& motion, Range blocks);
void finish_blocks(const MeshMotion& motion, Range blocks);

}  // namespace nuno
