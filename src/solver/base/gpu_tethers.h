// Tethers to vertices that are held as kernels that include sim/tethers.glsl read them.
#pragma once

#include <vector>

#include "gl/program.h"
#include "solver/base/gpu_table.h"
#include "solver/base/pin_tethers.h"

namespace nuno {

class GpuTethers
{
  public:
    // `model` must outlive it.
    explicit GpuTethers(const ClothModel& model);

    PinTethers& pins() { return pins_; }
    // Finds the tethers anew where what holds them or the parameters have changed; true where kernels must be compiled
    // for other defines().
    bool refresh(const SimParams& params);
    std::vector<Define> defines() const;
    void bind() const;

  private:
    PinTethers pins_;
    GpuTable anchors_, lengths_;
};

}  // namespace nuno
