// Backward Euler and a second-order, L-stable implicit method on CPU threads, each sheet on its own.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/base/cpu_air.h"
#include "solver/base/cpu_bodies.h"
#include "solver/base/host_solver.h"
#include "solver/implicit/implicit_sheet.h"

namespace nuno {

class CpuImplicit final : public HostSolver
{
  public:
    // params.method: implicit_euler or sdirk2.
    CpuImplicit(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override;
    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_lost() override;

    // Of all sheets together since it was made.
    SolveCounts counts() const;

  private:
    void move_vertices(std::span<const VertexMove> moves) override;
    struct Place
    {
        ImplicitSheet* sheet;
        std::size_t at;
    };

    void refresh(const SimParams& params);
    StageSettings settings(const SimParams& params, double time_s) const;
    void step_sheet(ImplicitSheet& sheet, const StepInput& input, int substep, const Team& team);
    void blow(const SimParams& params, double time_s, const Team& team);
    void start_pins(int substep);
    void end_pins(int substep);
    void place_vertex(std::uint32_t vertex, const glm::vec4& position);
    void set_velocity(std::uint32_t vertex, const glm::vec4& velocity);

    const ClothModel& model_;
    const Method method_;
    CpuBodies bodies_;
    std::vector<std::unique_ptr<ImplicitSheet>> sheets_;
    std::vector<Place> places_;  // of each vertex
    std::vector<float> inverse_mass_, area_;
    std::optional<SimParams> springs_of_;
    std::optional<CpuAir> air_;  // none: no force on faces
};

}  // namespace nuno
