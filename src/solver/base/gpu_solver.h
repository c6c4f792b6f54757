// What the solvers in compute shaders share: the state in buffers, its way in and out, and the inputs of their kernels.
#pragma once

#include <array>
#include <optional>

#include "gl/program.h"
#include "gl/readback.h"
#include "model/cloth_model.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/gpu_contacts.h"
#include "solver/base/gpu_table.h"

namespace nuno {

class GpuSolver : public ClothSolver
{
  public:
    explicit GpuSolver(const ClothModel& model);

    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void set_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count, ContactOrder order) override;
    void keep_contacts(const SimParams& params) override;
    void finish() override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_lost() override;
    std::uint32_t position_buffer() const override { return positions_[current_].buffer.id(); }

  protected:
    // Uploads the parameters and binds them; to call once a step, before kernels run.
    void bind_params(const SimParams& params);
    // Where contacts leave the velocities that they change.
    virtual const Buffer& contact_velocities() const { return velocities_[current_].buffer; }
    // To take them over from there.
    virtual void take_contact_velocities() {}
    // Writes a buffer of one vec4 a vertex, or reads it.
    void carry_buffer(Archive& archive, Buffer& buffer) const;
    // Binds one side as what kernels read (positions and velocities) and the other as what they write.
    void bind_state(int from, int to) const;
    // One invocation a vertex.
    void dispatch() const;

    const std::uint32_t vertex_count_;
    std::array<VertexBuffer, 2> positions_, velocities_;  // read from one, written to the other, in turns
    int current_ = 0;

  private:
    std::optional<GpuContacts> contacts_;  // made when there first are some
    Program lost_;
    Buffer params_, first_lost_;
    Readback readback_;
};

}  // namespace nuno
