// Rigid bodies and moving pins for solvers in compute shaders: what kernels that include sim/bodies.glsl read.
#pragma once

#include <vector>

#include "gl/program.h"
#include "model/body_steps.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/gpu_table.h"

namespace nuno {

class GpuBodies
{
  public:
    // `bodies` and `model` must outlive it. Error where the grids of meshes do not fit into what this device reads.
    GpuBodies(const Bodies& bodies, const ClothModel& model);

    // How many bodies of each shape there are, for the kernels.
    std::vector<Define> defines() const;

    // Finds and uploads the poses of the substeps to come, and binds them; to call once a step. Error where they do not
    // fit into what this device reads.
    void plan(const StepInput& input);
    // Tells a program that includes sim/bodies.glsl which substep is next.
    void set_substep(const Program& program, int substep) const;
    // The poses of a planned substep follow those of the one before by so many.
    int bodies_a_substep() const { return static_cast<int>(steps_.first_body(1)); }

    bool moves_pins() const { return !steps_.pins().empty(); }
    // Puts the moving pins where they are at the end of a substep, in the buffers bound as what kernels write; leaves
    // another program in use. Kernels before and after it need a barrier.
    void place_pins(int substep) const;

  private:
    const Bodies& bodies_;
    BodySteps steps_;
    GpuTable body_steps_, distances_, pin_vertices_, pin_steps_;
    Program place_pins_;
};

}  // namespace nuno
