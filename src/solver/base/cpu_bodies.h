// Rigid bodies and moving pins for solvers on CPU threads.
#pragma once

#include <array>

#include "core/thread_pool.h"
#include "solver/base/body_push_out.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

class CpuBodies
{
  public:
    // `bodies` and `model` must outlive it.
    CpuBodies(const Bodies& bodies, const ClothModel& model);

    // Finds the poses of the substeps to come; to call once a step, before the threads begin. `h` [s]: their length.
    void plan(const StepInput& input);
    void plan(double start_time_s, double h, int substep_count);
    BodyContacts contacts(int substep, const SimParams& params) const;

    // Puts the moving pins of these blocks of kLanes vertices where they are at the end of a substep.
    void place_pins(int substep, Range blocks, const Lanes3& x, const Lanes3& v) const;
    const BodySteps& steps() const { return steps_; }

  private:
    BodySteps steps_;
    std::array<std::size_t, 4> ends_;
    float h_ = 0;
};

}  // namespace nuno
