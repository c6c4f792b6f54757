// The classic Runge-Kutta method on CPU threads.
#pragma once

#include <array>

#include "solver/base/cpu_bodies.h"
#include "solver/base/cpu_forces.h"
#include "solver/base/cpu_solver.h"

namespace nuno {

struct Rk4Stage;

class CpuRk4 final : public CpuSolver
{
  public:
    CpuRk4(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override { return "rk4 on cpu"; }
    void step(const StepInput& input) override;

  private:
    void run_substep(const StepInput& input, int k, const Team& team);
    Rk4Stage stage_at(const StepInput& input, int substep, int number);

    CpuForces forces_;
    CpuBodies bodies_;
    std::array<VertexLanes3, 2> stage_positions_, stage_velocities_;  // read from one, written to the other
    VertexLanes3 velocity_sums_, acceleration_sums_;
};

}  // namespace nuno
