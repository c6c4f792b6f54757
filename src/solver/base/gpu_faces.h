// The pass over faces in a compute shader, and what kernels that include sim/forces.glsl read of it.
#pragma once

#include <optional>

#include "gl/program.h"
#include "model/face_table.h"
#include "solver/base/gpu_table.h"

namespace nuno {

class GpuFaces
{
  public:
    // Error where faces do not fit into what this device reads.
    explicit GpuFaces(const ClothModel& model);

    // Compiles the kernel for these parameters, where it is another than before.
    void refresh(const SimParams& params);
    int corner_quads() const { return corner_quads_; }

    // Computes the forces for the state bound as what kernels read and the parameters bound; leaves another program in
    // use. Waits for what wrote the state only where the caller has.
    void run(const SimParams& params, double time_s);
    // Binds the forces and where each vertex finds its own.
    void bind() const;

  private:
    const std::int32_t face_count_;
    int corner_quads_ = 0;
    std::optional<FaceForces> compiled_for_;
    Program program_;
    GpuTable corners_, faces_, rests_;
    VertexBuffer forces_;  // one a corner, and one for no corner
};

}  // namespace nuno
