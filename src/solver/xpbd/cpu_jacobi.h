// Small-step XPBD on CPU threads with all springs at once (sweep = jacobi): what the gpu does, bit for bit. On a CPU
// other orders are better.
#pragma once

#include <optional>

#include "solver/base/cpu_bodies.h"
#include "solver/base/cpu_forces.h"
#include "solver/base/cpu_solver.h"
#include "solver/base/cpu_tethers.h"
#include "solver/xpbd/jacobi_springs.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

class CpuJacobi final : public CpuSolver
{
  public:
    CpuJacobi(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override { return "xpbd on cpu"; }
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;

    struct Substep;  // what the kernels of one substep read and write

  private:
    void refresh(const SimParams& params);
    void refresh_springs(const SimParams& params);
    // For the next substep to begin at this vertex without a past.
    void forget_last(std::uint32_t vertex);
    Substep substep_at(const StepInput& input, int k);
    void run_substep(const Substep& s, int k, const Team& team);

    const ClothModel& model_;
    CpuForces forces_;
    CpuBodies bodies_;
    CpuTethers tethers_;
    SpringBlocks springs_, limits_;
    std::optional<SimParams> made_for_;
    bool masses_changed_ = true, last_is_known_ = false;
    VertexLanes3 predicted_, passed_;  // passed_: positions after every other pass
};

}  // namespace nuno
