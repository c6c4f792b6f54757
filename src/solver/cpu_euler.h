// Explicit and symplectic Euler on CPU threads: structure of arrays, kLanes vertices at once.
#pragma once

#include <array>
#include <vector>

#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "solver/cloth_solver.h"
#include "solver/spring_blocks.h"

namespace nuno {

// One coordinate of every vertex, with room for kLanes more before the first and after the last.
class PaddedLane
{
  public:
    explicit PaddedLane(std::uint32_t count);
    float* first() { return values_.data() + kPad; }
    const float* first() const { return values_.data() + kPad; }

  private:
    static constexpr int kPad = kLanes;
    std::vector<float> values_;
};

struct PaddedVec3
{
    explicit PaddedVec3(std::uint32_t count) : x(count), y(count), z(count) {}
    PaddedLane x, y, z;
};

class CpuEuler final : public ClothSolver
{
  public:
    CpuEuler(const ClothModel& model, const Colliders& colliders, Method method, ThreadPool& pool);

    std::string_view name() const override;
    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void finish() override {}
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_not_finite() override;
    std::uint32_t position_buffer() const override { return 0; }

  private:
    void step_part(const StepInput& input, Range blocks, class SpinBarrier* barrier);

    const Colliders& colliders_;
    const Method method_;
    ThreadPool& pool_;
    const std::uint32_t vertex_count_;
    const SpringBlocks springs_;
    std::array<PaddedVec3, 2> positions_;  // read from one, written to the other, in turns
    int current_ = 0;
    PaddedVec3 velocities_;
    PaddedLane inverse_mass_, area_;
};

}  // namespace nuno
