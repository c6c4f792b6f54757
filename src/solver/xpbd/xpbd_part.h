// One sheet as xpbd solves it: in strips, or in colours.
#pragma once

#include <span>

#include "model/spring_weights.h"
#include "model/tethers.h"
#include "solver/base/cpu_bodies.h"

namespace nuno {

struct XpbdStep
{
    const StepInput& input;
    int first_substep, substep_count;  // of those in `input`
    ThreadPool& pool;
    const CpuBodies& bodies;
    std::span<const SpringWeight> weights;     // one a spring of the model
    std::span<const Tether> tethers;           // as PinTethers has them, of all sheets; empty: none
    bool weights_changed, tethers_changed;     // since the step before
    std::span<const glm::vec3> accelerations;  // [m/s2] beside gravity, one a vertex of the model; empty: none
};

// Vertices are those of the model; a part reads and writes its own sheet's only.
class XpbdPart
{
  public:
    virtual ~XpbdPart() = default;
    virtual void upload(const ClothState& state) = 0;
    virtual void upload_positions(std::span<const glm::vec4> positions) = 0;
    virtual void upload_velocities(std::span<const glm::vec4> velocities) = 0;
    virtual void set_vertex(std::uint32_t vertex, glm::vec4 position) = 0;
    virtual void move_vertices(std::span<const VertexMove> moves) = 0;
    virtual void step(const XpbdStep& step) = 0;
    virtual void carry(Archive& archive, const SimParams& params) = 0;  // as a ClothSolver
    virtual void download_positions(std::span<glm::vec4> positions) const = 0;
    virtual void download_velocities(std::span<glm::vec4> velocities) const = 0;
};

}  // namespace nuno
