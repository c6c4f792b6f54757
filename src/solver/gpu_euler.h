// Explicit and symplectic Euler in a compute shader, one invocation a vertex.
#pragma once

#include <array>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"
#include "gl/readback.h"
#include "model/cloth_model.h"
#include "solver/cloth_solver.h"

namespace nuno {

// A buffer of a vec4 for each vertex that kernels write as a storage block and read as a buffer texture.
struct VertexBuffer
{
    explicit VertexBuffer(std::uint32_t vertex_count);
    Buffer buffer;
    BufferTexture texture;
};

class GpuEuler final : public ClothSolver
{
  public:
    // Error where springs or bodies do not fit into what this device reads.
    GpuEuler(const ClothModel& model, const Colliders& colliders, Method method);

    std::string_view name() const override;
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void finish() override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_not_finite() override;
    std::uint32_t position_buffer() const override { return positions_[current_].buffer.id(); }

  private:
    void upload_springs(const SpringTable& table);
    void dispatch() const;

    const Method method_;
    const std::uint32_t vertex_count_;
    Buffer colliders_;
    Program euler_, finite_;
    std::array<VertexBuffer, 2> positions_, velocities_;  // read from one, written to the other, in turns
    int current_ = 0;
    Buffer neighbours_, rest_lengths_, params_, first_bad_;
    BufferTexture neighbour_texture_, rest_length_texture_;
    Readback readback_;
};

}  // namespace nuno
