// The state in buffers, and its way in and out.
#include "solver/base/gpu_solver.h"

#include <vector>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"

namespace nuno {

// Every field is a 4-byte scalar, so std140 lays them out as the struct does.
static_assert(sizeof(SimParams) % 4 == 0 && std::is_trivially_copyable_v<SimParams>);

GpuSolver::GpuSolver(const ClothModel& model)
    : vertex_count_(model.vertex_count()),
      positions_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      velocities_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      lost_(compute_program("sim/lost.comp")),
      params_((sizeof(SimParams) + 15) / 16 * 16, nullptr, GL_DYNAMIC_DRAW),
      first_lost_(sizeof(std::uint32_t), nullptr, GL_DYNAMIC_READ)
{
}

void GpuSolver::upload(const ClothState& state)
{
    barrier_compute_to_upload();
    positions_[current_].buffer.update(0, state.positions);
    velocities_[current_].buffer.update(0, state.velocities);
}

void GpuSolver::upload_positions(std::span<const glm::vec4> positions)
{
    barrier_compute_to_upload();
    positions_[current_].buffer.update(0, std::as_bytes(positions));
}

void GpuSolver::upload_velocities(std::span<const glm::vec4> velocities)
{
    barrier_compute_to_upload();
    velocities_[current_].buffer.update(0, std::as_bytes(velocities));
}

void GpuSolver::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    barrier_compute_to_upload();
    const glm::vec3 at_rest(0);
    positions_[current_].buffer.update(vertex * sizeof position, std::as_bytes(std::span(&position, 1)));
    velocities_[current_].buffer.update(vertex * sizeof position, std::as_bytes(std::span(&at_rest, 1)));
}

void GpuSolver::set_contacts(std::span<const LayerContact> contacts, std::uint32_t, ContactOrder order)
{
    if (contacts.empty() && !contacts_) return;
    if (!contacts_) contacts_.emplace(vertex_count_);
    barrier_compute_to_upload();
    contacts_->set(contacts, positions_[current_].buffer, order);
}

void GpuSolver::keep_contacts(const SimParams& params)
{
    if (!contacts_ || contacts_->empty()) return;
    contacts_->answer(positions_[current_].buffer, velocities_[current_].buffer, contact_velocities(), params);
    take_contact_velocities();
}

void GpuSolver::bind_params(const SimParams& params)
{
    params_.update(0, std::as_bytes(std::span(&params, 1)));
    params_.bind_block(GL_UNIFORM_BUFFER, BLOCK_PARAMS);
}

void GpuSolver::bind_state(int from, int to) const
{
    positions_[from].texture.bind(UNIT_POSITIONS);
    velocities_[from].texture.bind(UNIT_VELOCITIES);
    positions_[to].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
    velocities_[to].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
}

void GpuSolver::carry_buffer(Archive& archive, Buffer& buffer) const
{
    std::vector<glm::vec4> values(vertex_count_);
    barrier_compute_to_readback();
    if (!archive.reads()) buffer.read(0, std::span(values));
    archive.values(std::span(values));
    barrier_compute_to_upload();
    if (archive.reads()) buffer.update(0, values);
}

void GpuSolver::dispatch() const { glDispatchCompute((vertex_count_ + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1); }

void GpuSolver::finish() { glFinish(); }

void GpuSolver::download_positions(std::span<glm::vec4> positions)
{
    readback_.begin(positions_[current_].buffer.id(), positions.size_bytes());
    readback_.finish(positions);
}

void GpuSolver::download_velocities(std::span<glm::vec4> velocities)
{
    readback_.begin(velocities_[current_].buffer.id(), velocities.size_bytes());
    readback_.finish(velocities);
}

std::optional<std::uint32_t> GpuSolver::first_lost()
{
    const std::uint32_t none = ~0u;
    std::uint32_t first = none;
    barrier_compute_to_upload();
    first_lost_.update(0, std::as_bytes(std::span(&none, 1)));
    lost_.use();
    lost_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    positions_[current_].texture.bind(UNIT_POSITIONS);
    velocities_[current_].texture.bind(UNIT_VELOCITIES);
    first_lost_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_FIRST_LOST);
    dispatch();
    readback_.begin(first_lost_.id(), sizeof first);
    readback_.finish(std::span(&first, 1));
    return first == none ? std::nullopt : std::optional(first);
}

}  // namespace nuno
