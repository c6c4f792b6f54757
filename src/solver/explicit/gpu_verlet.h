// Velocity Verlet in a compute shader, one invocation a vertex.
#pragma once

#include <array>
#include <optional>

#include "solver/base/gpu_bodies.h"
#include "solver/base/gpu_forces.h"
#include "solver/base/gpu_solver.h"

namespace nuno {

class GpuVerlet final : public GpuSolver
{
  public:
    // Error where springs, faces or bodies do not fit into what this device reads.
    GpuVerlet(const ClothModel& model, const Bodies& bodies, const SimParams& params);

    std::string_view name() const override { return "verlet on gpu"; }
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;

  private:
    void take_contact_velocities() override { accelerations_for_.reset(); }
    void compile();
    void find_accelerations(const StepInput& input);
    // Ends substep `substep` - 1 and begins substep `substep`, where there are such.
    void pass(const StepInput& input, int substep);
    void run(const Program& program, const StepInput& input, double time_s);

    GpuForces forces_;
    GpuBodies bodies_;
    std::array<VertexBuffer, 2> predicted_;       // velocities at which accelerations are taken
    Buffer accelerations_;                        // of the state at the end of the last substep
    std::optional<SimParams> accelerations_for_;  // none: they are to be found anew
    Program kick_, drift_, kick_and_drift_;
};

}  // namespace nuno
