// The error in time of one frame, estimated beside a run: the frame that comes next with the substeps of the run, and
// with twice as many.
#pragma once

#include "core/thread_pool.h"
#include "sim/simulation.h"

namespace nuno {

// Root mean square over the vertices of how far the two are apart [m]; infinite where one loses a vertex. Without layers
// meeting. The run goes on as if it had not been asked: same bits.
double doubling_error_m(Simulation& simulation, ThreadPool& pool);

}  // namespace nuno
