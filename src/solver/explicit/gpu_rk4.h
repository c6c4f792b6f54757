// The classic Runge-Kutta method in a compute shader, one invocation a vertex.
#pragma once

#include <array>

#include "solver/base/gpu_bodies.h"
#include "solver/base/gpu_forces.h"
#include "solver/base/gpu_solver.h"

namespace nuno {

class GpuRk4 final : public GpuSolver
{
  public:
    // Error where springs, faces or bodies do not fit into what this device reads.
    GpuRk4(const ClothModel& model, const Bodies& bodies, const SimParams& params);

    std::string_view name() const override { return "rk4 on gpu"; }
    void step(const StepInput& input) override;

  private:
    void compile();
    void stage(const StepInput& input, int substep, int number);

    GpuForces forces_;
    GpuBodies bodies_;
    std::array<VertexBuffer, 2> stage_positions_, stage_velocities_;  // read from one, written to the other
    Buffer velocity_sums_, acceleration_sums_;
    Program first_, middle_, last_;
};

}  // namespace nuno
