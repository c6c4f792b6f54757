// The extremes on the gpu.
#include "solver/extremes.h"

namespace nuno {

std::vector<Extreme> extremes_to_test() { return stable_on(Backend::gpu); }

}  // namespace nuno
