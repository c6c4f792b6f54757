// The extremes on the cpu.
#include "solver/extremes.h"

namespace nuno {

std::vector<Extreme> extremes_to_test() { return stable_on(Backend::cpu); }

}  // namespace nuno
