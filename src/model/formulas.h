// The shared physics formulas as C++: `formulas` in float, `formulas_f64` in double, `formulas_wide` for kLanes
// particles at once. All three and the GLSL kernels (shaders/shared/dialect.glsl) read the same text.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

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
#define SHARED_FN static NUNO_WIDE_INLINE

namespace nuno {

// The formulas for kCount particles at once, as static members so that kernels can be templates on the count.
template <int kCount>
struct WideFormulas
{
    using Real = Wide<kCount>;
    using Vec3 = WideVec<kCount>;
    using Bits = typename Real::Bits;
    static NUNO_WIDE_INLINE Real real_of_bits(Bits a) { return Real::of_bits(a); }
#include "shaders/shared/vector.h"
//
#include "shaders/shared/aero.h"
#include "shaders/shared/body_shapes.h"
#include "shaders/shared/euler.h"
#include "shaders/shared/forces.h"
#include "shaders/shared/gust.h"
#include "shaders/shared/membrane.h"
#include "shaders/shared/push_out.h"
#include "shaders/shared/rk4.h"
#include "shaders/shared/vbd.h"
#include "shaders/shared/verlet.h"
#include "shaders/shared/xpbd.h"
};

using formulas_wide = WideFormulas<kLanes>;

}  // namespace nuno

#undef SHARED_FN
#undef PRECISE
