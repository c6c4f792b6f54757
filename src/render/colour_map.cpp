// The shared formula as C++.
#include "render/colour_map.h"

#include <algorithm>

#define SHARED_FN inline

namespace nuno {
namespace formulas {
namespace {

using Real = float;
using Vec3 = glm::vec3;
inline Real max_real(Real a, Real b) { return std::max(a, b); }
inline Real min_real(Real a, Real b) { return std::min(a, b); }
#include "shaders/shared/viridis.h"

}  // namespace
}  // namespace formulas

glm::vec3 viridis(float value) { return formulas::viridis(value); }

}  // namespace nuno
