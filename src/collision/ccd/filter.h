// Answers most pairs in double, with certainty; the others are left to exact arithmetic.
#pragma once

#include "collision/ccd/four_points.h"

namespace nuno {

enum class FilterAnswer
{
    none,
    impact,   // the first is at `time` or up to 1e-9 later
    unknown,  // there is none before `time`
};

struct FilterVerdict
{
    FilterAnswer answer;
    double time;
};

FilterVerdict filter_vertex_face(const FourPoints& t0, const FourPoints& t1);
FilterVerdict filter_edge_edge(const FourPoints& t0, const FourPoints& t1);

}  // namespace nuno
