// Small-step XPBD on CPU threads (M. Macklin et al., Small steps in physics simulation, 2019): each substep moves every
// vertex freely, then projects every spring in one fixed order and once more in the exact reverse of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/base/cpu_air.h"
#include "solver/base/host_solver.h"
#include "solver/base/pin_tethers.h"
#include "solver/xpbd/xpbd_part.h"

namespace nuno {

class CpuXpbd final : public HostSolver
{
  public:
    // `model`, `bodies` and `pool` must outlive it. params.sweep: rows needs grid sheets, else Error. `lanes` of
    // vectors, 16, 8 or 4, at most what the machine has, changes nothing but speed; 0: what the machine has.
    CpuXpbd(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool, int lanes = 0);

    std::string_view name() const override { return "xpbd on cpu"; }
    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_lost() override;

  private:
    void move_vertices(std::span<const VertexMove> moves) override;
    void step_parts(const XpbdStep& step);
    void blow(const SimParams& params, double time_s);

    const ClothModel& model_;
    CpuBodies bodies_;
    PinTethers tethers_;
    std::vector<std::unique_ptr<XpbdPart>> parts_;  // one a sheet
    std::vector<SpringWeight> weights_;
    std::optional<SimParams> weights_for_;
    std::optional<CpuAir> air_;
    std::vector<glm::vec3> accelerations_;           // by air
    std::vector<glm::vec4> positions_, velocities_;  // for a while
};

}  // namespace nuno
