// Reading and writing vectors of a sheet in strips.
#pragma once

#include "model/formulas.h"
#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/strip_layout.h"

namespace nuno {

// kLaneCount lanes of a vector of positions.
template <int kLaneCount>
struct StripLane
{
    using Real = Wide<kLaneCount>;
    using Vec3 = WideVec<kLaneCount>;
    using Formulas = WideFormulas<kLaneCount>;

    static NUNO_WIDE_INLINE Vec3 load(const float* from)
    {
        return {Real(from), Real(from + kStrips), Real(from + 2 * kStrips)};
    }
    static NUNO_WIDE_INLINE void store(float* to, const Vec3& a)
    {
        a.x.store(to);
        a.y.store(to + kStrips);
        a.z.store(to + 2 * kStrips);
    }
    static NUNO_WIDE_INLINE Vec3 wide(const glm::vec3& a) { return {Real(a.x), Real(a.y), Real(a.z)}; }
};

}  // namespace nuno
