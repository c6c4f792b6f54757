// What the solvers on CPU threads share: the state in lanes, and its way in and out.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "model/cloth_model.h"
#include "solver/base/host_solver.h"
#include "solver/base/team.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

class CpuSolver : public HostSolver
{
  public:
    CpuSolver(const ClothModel& model, ThreadPool& pool);
    // With the vertices in another order: `places` by vertex, of `place_count` in all.
    CpuSolver(std::vector<std::uint32_t> places, std::uint32_t place_count, ThreadPool& pool);

    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_lost() override;

  protected:
    void move_vertices(std::span<const VertexMove> moves) override;
    // The state on one side, as kernels take it.
    StateLanes state(int side);
    // Calls body on each thread of a team.
    void run_team(const std::function<void(const Team& team)>& body);
    // The same for `count` substeps, one after another, each of which goes from one side of the state to the other.
    void run_substeps(int count, const std::function<void(int substep, const Team& team)>& body);
    // Blocks of kLanes vertices.
    int block_count() const { return static_cast<int>((place_count_ + kLanes - 1) / kLanes); }

    std::uint32_t place(std::uint32_t vertex) const { return places_.empty() ? vertex : places_[vertex]; }

    const std::vector<std::uint32_t> places_;  // empty: the order of the model
    const std::uint32_t vertex_count_, place_count_;
    std::array<VertexLanes3, 2> positions_, velocities_;  // read from one, written to the other, in turns
    int current_ = 0;
    VertexLane inverse_mass_, area_;
};

}  // namespace nuno
