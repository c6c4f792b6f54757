// The continuous test in exact arithmetic, for the pairs that double cannot decide.
#pragma once

#include <optional>

#include "collision/ccd/four_points.h"

namespace nuno {

// The first time of contact in [0, 1], rounded down by at most 4e-15; none where there is no contact. Before
// `free_until` there must be none. Coordinates must be finite.
std::optional<double> exact_impact(PairKind kind, const FourPoints& t0, const FourPoints& t1, double free_until = 0);

}  // namespace nuno
