// Explicit and symplectic Euler in a compute shader, one invocation a vertex.
#pragma once

#include "solver/base/gpu_bodies.h"
#include "solver/base/gpu_forces.h"
#include "solver/base/gpu_solver.h"

namespace nuno {

class GpuEuler final : public GpuSolver
{
  public:
    // Error where springs or bodies do not fit into what this device reads.
    GpuEuler(const ClothModel& model, const Bodies& bodies, const SimParams& params);

    std::string_view name() const override;
    void step(const StepInput& input) override;

  private:
    void compile();
    // Whether one work group takes the whole cloth, substep after substep.
    bool is_small() const;
    void run_small(const StepInput& input);
    void run_substep(const StepInput& input, int k);

    const Method method_;
    GpuForces forces_;
    GpuBodies bodies_;
    Program euler_;
    // Of a small cloth.
    GpuTable winds_;
    VertexBuffer shown_positions_, shown_velocities_;  // two a vertex
};

}  // namespace nuno
