// Explicit and symplectic Euler on CPU threads: structure of arrays, kLanes vertices at once.
#pragma once

#include "solver/base/cpu_bodies.h"
#include "solver/base/cpu_forces.h"
#include "solver/base/cpu_solver.h"

namespace nuno {

class CpuEuler final : public CpuSolver
{
  public:
    CpuEuler(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override;
    void step(const StepInput& input) override;

  private:
    void run_substep(const StepInput& input, int k, const Team& team);

    const Method method_;
    CpuForces forces_;
    CpuBodies bodies_;
};

}  // namespace nuno
