// Vertex block descent on CPU threads: the vertices of a colour at once, colour after colour.
#pragma once

#include <optional>

#include "model/vertex_colours.h"
#include "solver/base/cpu_bodies.h"
#include "solver/base/cpu_forces.h"
#include "solver/base/cpu_solver.h"
#include "solver/base/cpu_tethers.h"
#include "solver/vbd/vbd_terms.h"

namespace nuno {

class CpuVbd final : public CpuSolver
{
  public:
    CpuVbd(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override { return "vbd on cpu"; }
    void upload(const ClothState& state) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;

    struct Substep;  // what the kernels of one substep read and write

  private:
    CpuVbd(const ClothModel& model, const Bodies& bodies, VertexColours colours, ThreadPool& pool);
    void refresh(const SimParams& params);
    Substep substep_at(const StepInput& input, int k);
    void run_substep(const Substep& s, int k, const Team& team);

    const ClothModel& model_;
    const VertexColours colours_;
    const ClothModel placed_;  // `model` by place, as all else here
    CpuForces forces_;
    CpuBodies bodies_;
    std::optional<SimParams> terms_for_;
    VbdTerms terms_{};
    VertexLanes3 moves_, targets_;  // [m] from the start of the substep
    VertexLane mobility_;           // [m/N]
    CpuTethers tethers_;
};

}  // namespace nuno
