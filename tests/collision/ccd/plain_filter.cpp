// Compiles the filter a second time, in a namespace of its own, for the least instruction set.
#include "collision/ccd/plain_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <glm/vec3.hpp>

#include "collision/ccd/four_points.h"
#include "model/wide.h"

#undef NUNO_SIMD_CLONES
#define NUNO_SIMD_CLONES
#define filter_vertex_face plain_vertex_face
#define filter_edge_edge plain_edge_edge
#define filter plain_filter
#include "src/collision/ccd/filter.cpp"  // NOLINT

namespace nuno {

FilterVerdict plainly_filtered(const Query& query)
{
    return query.kind == PairKind::vertex_face ? plain_vertex_face(query.t0, query.t1)
                                               : plain_edge_edge(query.t0, query.t1);
}

}  // namespace nuno
