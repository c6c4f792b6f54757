// The reference: the equation of motion in double, integrated with as many steps as its error asks for.
#pragma once

#include <optional>
#include <vector>

#include "core/thread_pool.h"
#include "model/force_model.h"
#include "solver/base/cpu_bodies.h"
#include "solver/base/host_solver.h"
#include "solver/explicit/runge_kutta.h"

namespace nuno {

class CpuReference final : public HostSolver
{
  public:
    CpuReference(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool);

    std::string_view name() const override { return "reference on cpu"; }
    // What is uploaded as it was downloaded stays as precise as it is here.
    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void step(const StepInput& input) override;
    void carry(Archive& archive, const SimParams& params) override;
    void download_positions(std::span<glm::vec4> positions) override;
    void download_velocities(std::span<glm::vec4> velocities) override;
    std::optional<std::uint32_t> first_lost() override;

    // Steps taken since it was made.
    long step_count() const { return step_count_; }

    // Error of a step [m] that is let pass: this share of `tolerance` times the shortest thread.
    static constexpr double kErrorShare = 1e-4;
    // The tolerance where the parameters leave it open.
    static constexpr double kOwnTolerance = 0.001;

  private:
    void move_vertices(std::span<const VertexMove> moves) override;
    void refresh(const SimParams& params);
    double advance(const SimParams& params, double time_s, double longest_s);
    void start_pins();
    void meet_bodies(const SimParams& params);

    const ClothModel& model_;
    CpuBodies bodies_;
    std::optional<ForceModel> forces_;
    SimParams params_{};
    double shortest_thread_ = 0;  // [m]
    DormandPrince method_;
    MotionInDouble now_, next_;
    std::vector<double> inverse_mass_;
    std::vector<float> area_;
    double step_s_ = 0;  // length of the next step; 0: not known
    bool fresh_ = true;  // the state was changed since the last step
    long step_count_ = 0;
};

}  // namespace nuno
