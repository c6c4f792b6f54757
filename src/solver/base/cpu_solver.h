// What the solvers on CPU threads share: the state in lanes, and its way in and out.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

class CpuSolver : public ClothSolver
{
  public:
    CpuSolver(const ClothModel& model, ThreadPool& pool);
    // With the vertices in another order: `places` by vertex, of `place_count` in all.
    CpuSolver(std::vector<std::uint32_t> places, std::uint32_t place_count, ThreadPool& pool);

    void upload(const ClothState& state) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void finish() override {}
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_not_finite() override;
    std::uint32_t position_buffer() const override { return 0; }

  protected:
    // Calls body(blocks, barrier) on every thread with its part of the blocks of kLanes vertices; the barrier is null
    // where one thread does it all.
    void run_blocks(const std::function<void(Range blocks, SpinBarrier* barrier)>& body);
    // The same with the parts left to the body; `team` says which of how many it is.
    struct Team
    {
        int thread, thread_count;
        SpinBarrier* barrier;

        void wait() const
        {
            if (barrier) barrier->arrive_and_wait();
        }
        Range part(int begin, int end) const
        {
            const Range range = part_of(end - begin, 1, thread, thread_count);
            return {begin + range.begin, begin + range.end};
        }
    };
    void run_team(const std::function<void(const Team& team)>& body);
    int block_count() const { return static_cast<int>((place_count_ + kLanes - 1) / kLanes); }

    std::uint32_t place(std::uint32_t vertex) const { return places_.empty() ? vertex : places_[vertex]; }

    ThreadPool& pool_;
    const std::vector<std::uint32_t> places_;  // empty: the order of the model
    const std::uint32_t vertex_count_, place_count_;
    std::array<VertexLanes3, 2> positions_, velocities_;  // read from one, written to the other, in turns
    int current_ = 0;
    VertexLane inverse_mass_, area_;
};

}  // namespace nuno
