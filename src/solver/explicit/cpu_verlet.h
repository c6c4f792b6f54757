// Velocity Verlet on CPU threads.
#pragma once

#include <array>
#include <optional>

#include "solver/base/cpu_bodies.h"
#include "solver/base/cpu_forces.h"
#include "solver/base/cpu_solver.h"

namespace nuno {

struct VerletPass;

class CpuVerlet final : public CpuSolver
{
  public:
    CpuVerlet(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override { return "verlet on cpu"; }
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;

  private:
    void move_vertices(std::span<const VertexMove> moves) override;
    void step_part(const StepInput& input, const Team& team);
    VerletPass pass_at(const StepInput& input, int substep);

    CpuForces forces_;
    CpuBodies bodies_;
    std::array<VertexLanes3, 2> predicted_;       // velocities at which accelerations are taken
    VertexLanes3 accelerations_;                  // of the state at the end of the last substep
    std::optional<SimParams> accelerations_for_;  // none: they are to be found anew
};

}  // namespace nuno
