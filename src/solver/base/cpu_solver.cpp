// The state in lanes, and its way in and out.
#include "solver/base/cpu_solver.h"

#include <utility>

namespace nuno {

CpuSolver::CpuSolver(const ClothModel& model, ThreadPool& pool)
    : HostSolver(pool),
      vertex_count_(model.vertex_count()),
      place_count_(vertex_count_),
      positions_{VertexLanes3(place_count_), VertexLanes3(place_count_)},
      velocities_{VertexLanes3(place_count_), VertexLanes3(place_count_)},
      inverse_mass_(place_count_),
      area_(place_count_)
{
}

CpuSolver::CpuSolver(std::vector<std::uint32_t> places, std::uint32_t place_count, ThreadPool& pool)
    : HostSolver(pool),
      places_(std::move(places)),
      vertex_count_(static_cast<std::uint32_t>(places_.size())),
      place_count_(place_count),
      positions_{VertexLanes3(place_count_), VertexLanes3(place_count_)},
      velocities_{VertexLanes3(place_count_), VertexLanes3(place_count_)},
      inverse_mass_(place_count_),
      area_(place_count_)
{
}

void CpuSolver::upload(const ClothState& state)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i) {
        positions_[current_].put(place(i), state.positions[i]);
        velocities_[current_].put(place(i), state.velocities[i]);
        inverse_mass_.first()[place(i)] = state.positions[i].w;
        area_.first()[place(i)] = state.velocities[i].w;
    }
}

void CpuSolver::upload_positions(std::span<const glm::vec4> positions)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i) positions_[current_].put(place(i), positions[i]);
}

void CpuSolver::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i) velocities_[current_].put(place(i), velocities[i]);
}

void CpuSolver::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    positions_[current_].put(place(vertex), position);
    velocities_[current_].put(place(vertex), glm::vec4(0));
    inverse_mass_.first()[place(vertex)] = position.w;
}

void CpuSolver::move_vertices(std::span<const VertexMove> moves)
{
    for (const VertexMove& move : moves) {
        const std::uint32_t i = place(move.vertex);
        positions_[current_].put(i, glm::vec4(move.position, 0));
        velocities_[current_].put(i, velocities_[current_].at(i, 0) + glm::vec4(move.velocity_gain, 0));
    }
}

StateLanes CpuSolver::state(int side)
{
    const auto at = static_cast<std::size_t>(side);
    return {positions_[at].lanes(), velocities_[at].lanes(), inverse_mass_.first(), area_.first()};
}

void CpuSolver::run_team(const std::function<void(const Team&)>& body)
{
    nuno::run_team(pool_, team_size(pool_, vertex_count_), body);
}

void CpuSolver::run_substeps(int count, const std::function<void(int, const Team&)>& body)
{
    run_team([&](const Team& team) {
        for (int k = 0; k < count; ++k) body(k, team);
    });
    current_ = (current_ + count) % 2;
}

void CpuSolver::download_positions(std::span<glm::vec4> positions)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i)
        positions[i] = positions_[current_].at(place(i), inverse_mass_.first()[place(i)]);
}

void CpuSolver::download_velocities(std::span<glm::vec4> velocities)
{
    for (std::uint32_t i = 0; i < vertex_count_; ++i)
        velocities[i] = velocities_[current_].at(place(i), area_.first()[place(i)]);
}

std::optional<std::uint32_t> CpuSolver::first_lost()
{
    const Lanes3 x = positions_[current_].lanes(), v = velocities_[current_].lanes();
    for (std::uint32_t vertex = 0; vertex < vertex_count_; ++vertex) {
        const std::uint32_t i = place(vertex);
        for (const float a : {x.x[i], x.y[i], x.z[i], v.x[i], v.y[i], v.z[i]})
            if (is_lost(a)) return vertex;
    }
    return std::nullopt;
}

}  // namespace nuno
