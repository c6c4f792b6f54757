// The filter, and exact arithmetic for what it leaves open.
#include "collision/ccd/impact.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/ccd/exact_impact.h"
#include "collision/ccd/filter.h"

namespace nuno {
namespace {

[[maybe_unused]] bool is_finite(const FourPoints& points)
{
    return std::all_of(points.begin(), points.end(), [](const glm::dvec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

}  // namespace

std::optional<double> impact_of_near_pair(PairKind kind, const FourPoints& t0, const FourPoints& t1)
{
    assert(is_finite(t0) && is_finite(t1));
    const FilterVerdict verdict = kind == PairKind::vertex_face ? filter_vertex_face(t0, t1) : filter_edge_edge(t0, t1);
    if (verdict.answer == FilterAnswer::none) return std::nullopt;
    if (verdict.answer == FilterAnswer::impact) return verdict.time;
    return exact_impact(kind, t0, t1, verdict.time);
}

}  // namespace nuno
