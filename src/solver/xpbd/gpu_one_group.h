// XPBD by one work group, which takes a small cloth through many substeps in one dispatch.
#pragma once

#include <array>
#include <vector>

#include <glm/vec4.hpp>

#include "solver/base/gpu_bodies.h"
#include "solver/xpbd/gpu_springs.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

class GpuOneGroup
{
  public:
    // At most GpuSprings::kSmallVertices.
    explicit GpuOneGroup(std::uint32_t vertex_count);

    // Compiles the kernels for springs of this kind; `motion`: defines of forces, bodies and tethers.
    void compile(const GpuSprings& springs, const std::vector<Define>& motion);

    // Both sides of the state, of which a substep reads one and writes the other.
    struct Sides
    {
        const std::array<VertexBuffer, 2>& positions;
        const std::array<VertexBuffer, 2>& velocities;
        int from;  // the side that the first substep reads; the other holds the state one substep ago
    };
    // What every substep does.
    struct Work
    {
        const GpuSprings& springs;
        const GpuBodies& bodies;  // planned, and moving no pins
        int pairs;                // of sweeps
        SubstepTimes times;
    };
    // Whether so much work is not too much for a substep in one dispatch.
    bool does(const Work& work) const { return most_substeps(work) > 0; }
    // One substep for each of `commons`, the acceleration [m/s2] of all vertices in it; without forces on faces. Reads
    // the tethers bound.
    void run(const Sides& sides, const Work& work, const std::vector<glm::vec4>& commons);

    // `pairs` times over all springs, there and back, in these positions.
    void sweep(const GpuSprings& springs, int pairs, const VertexBuffer& positions) const;

  private:
    void copy(const Sides& sides, bool back) const;
    int turns_of_pair(const GpuSprings& springs) const;
    int most_substeps(const Work& work) const;

    const std::uint32_t vertex_count_;
    const int group_;     // invocations
    VertexBuffer state_;  // rows as sim/xpbd_small.comp has them
    GpuTable commons_;
    Program substeps_, sweep_;
};

}  // namespace nuno
