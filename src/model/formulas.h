// The shared physics formulas as C++: `formulas` in float, `formulas_f64` in double, `formulas_wide` for kLanes
// particles at once. All three and the GLSL kernels (shaders/shared/dialect.glsl) read the same text.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "model/wide.h"

#define SHARED_FN inline
#define PRECISE

namespace nuno::formulas {
using Real = float;
using Vec3 = glm::vec3;
#include "model/formulas_scalar.inc"
}  // namespace nuno::formulas

namespace nuno::formulas_f64 {
using Real = double;
using Vec3 = glm::dvec3;
#include "model/formulas_scalar.inc"
}  // namespace nuno::formulas_f64

#undef SHARED_FN
#define SHARED_FN NUNO_WIDE_INLINE

namespace nuno::formulas_wide {
using Real = WideFloat;
using Vec3 = WideVec3;
#include "shaders/shared/vector.h"
//
#include "shaders/shared/euler.h"
#include "shaders/shared/forces.h"
#include "shaders/shared/push_out.h"
}  // namespace nuno::formulas_wide

#undef SHARED_FN
#undef PRECISE
