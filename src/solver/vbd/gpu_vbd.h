// Vertex block descent in compute shaders: one dispatch a colour.
#pragma once

#include <optional>
#include <vector>

#include "model/vertex_colours.h"
#include "solver/base/gpu_bodies.h"
#include "solver/base/gpu_forces.h"
#include "solver/base/gpu_solver.h"
#include "solver/base/gpu_tethers.h"
#include "solver/vbd/vbd_terms.h"

namespace nuno {

class GpuVbd final : public GpuSolver
{
  public:
    // Error where springs or bodies do not fit into what this device reads.
    GpuVbd(const ClothModel& model, const Bodies& bodies, const SimParams& params);

    std::string_view name() const override { return "vbd on gpu"; }
    void upload(const ClothState& state) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;

  private:
    void refresh(const SimParams& params);
    void compile();
    void set_uniforms();
    void run_substep(const StepInput& input, int k);
    void sweep();

    const ClothModel& model_;
    GpuForces forces_;
    GpuBodies bodies_;
    GpuTethers tethers_;
    std::optional<SimParams> made_for_;
    VbdTerms terms_{};
    std::vector<std::uint32_t> first_place_;  // of each colour, and one past the last
    GpuTable order_;
    VertexBuffer moves_, targets_;
    Program predict_, descend_, finish_;
};

}  // namespace nuno
