// The forces of a model as kernels that include sim/forces.glsl read them.
#pragma once

#include <optional>
#include <vector>

#include "gl/program.h"
#include "model/spring_weights.h"
#include "solver/base/gpu_faces.h"
#include "solver/base/gpu_table.h"

namespace nuno {

class GpuForces
{
  public:
    // `rule` kNoSprings: forces on faces alone.
    explicit GpuForces(const ClothModel& model, SpringRule rule = kTrueSprings);

    // Uploads the springs anew where their parameters have changed; true where kernels must be compiled for other
    // defines().
    // Error where springs do not fit into what this device reads.
    bool refresh(const SimParams& params);
    std::vector<Define> defines() const;
    // Whether there are forces on faces.
    bool on_faces() const { return face_forces_.any(); }
    // Binds the textures of springs and faces.
    void bind() const;
    // Where there are forces on faces, computes them for the state bound as what kernels read; leaves another program
    // in use then. To call before each kernel that takes accelerations.
    void run_face_pass(double time_s);

  private:
    void upload_springs(const SpringEntries& entries);

    const ClothModel& model_;
    const SpringRule rule_;
    std::optional<SimParams> made_for_;
    int quad_count_ = 0;
    bool damped_ = false;
    std::optional<GpuFaces> faces_;
    FaceForces face_forces_{};
    GpuTable neighbours_, stiffness_, tension_, axial_;
};

}  // namespace nuno
