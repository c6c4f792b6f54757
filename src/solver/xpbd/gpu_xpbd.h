// Small-step XPBD in compute shaders, colour by colour or all springs at once: bit for bit what the cpu does with the
// same sweep.
#pragma once

#include <optional>
#include <vector>

#include "solver/base/gpu_bodies.h"
#include "solver/base/gpu_forces.h"
#include "solver/base/gpu_solver.h"
#include "solver/base/gpu_tethers.h"
#include "solver/xpbd/gpu_constraints.h"
#include "solver/xpbd/gpu_gather.h"
#include "solver/xpbd/gpu_one_group.h"

namespace nuno {

class GpuXpbd final : public GpuSolver
{
  public:
    // Error where params.sweep is one that only the cpu has, or where constraints or bodies do not fit into what this
    // device reads.
    GpuXpbd(const ClothModel& model, const Bodies& bodies, const SimParams& params);

    std::string_view name() const override { return "xpbd on gpu"; }
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;

  private:
    const Buffer& contact_velocities() const override { return given_; }
    void take_contact_velocities() override { forget_last(false); }
    void refresh(const SimParams& params);
    // True where others than before come.
    bool refresh_springs(const SimParams& params);
    void refresh_constraints(const SimParams& params, bool others);
    void compile(bool new_motion, bool new_springs);
    // Makes the motion before the present one what assumed_last has: of all vertices, or of those whose velocity is not
    // that in given_, which they take.
    void forget_last(bool all);
    void run_substep(const StepInput& input, int k);
    // Whether one work group takes the whole cloth, substep after substep, and doing so.
    bool is_small(const SimParams& params) const;
    void run_small(const StepInput& input);
    GpuOneGroup::Work small_work(const SimParams& params) const;
    // Between the beginning and the end of a substep; positions_[to] is what they move.
    void project_springs(const SimParams& params, int to) const;

    const ClothModel& model_;
    GpuForces forces_;
    GpuBodies bodies_;
    GpuTethers tethers_;
    std::optional<GpuConstraints> constraints_;  // in colours
    std::optional<GpuGather> gather_;            // all springs at once; one of the two is there
    std::optional<GpuOneGroup> one_group_;       // where the cloth is small
    std::vector<float> inverse_masses_;          // one a vertex
    std::optional<SimParams> made_for_;
    bool masses_changed_ = true, last_is_known_ = false;
    VertexBuffer predicted_;
    Buffer given_;  // velocities
    Program predict_, finish_, forget_;
};

}  // namespace nuno
