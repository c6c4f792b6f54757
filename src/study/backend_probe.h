// A quick look at how fast each backend runs one cloth on this machine.
#pragma once

#include "model/body.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

struct BackendSpeed
{
    double cpu_ns = 0, gpu_ns = 0;  // a particle and substep, the best of a few interleaved runs
};

// Takes some tens of milliseconds; an OpenGL context must be current.
BackendSpeed probe_backends(const ClothModel& model, const Bodies& bodies, const SimParams& params);

}  // namespace nuno
