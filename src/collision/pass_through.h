// Which vertices went through a face between two poses of the cloth: a measurement of what a response let slip.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/element_query.h"
#include "collision/vertex_face.h"
#include "core/thread_pool.h"

namespace nuno {

// A point that goes straight from t0 to t1 [m].
struct Path
{
    glm::dvec3 t0, t1;
};

inline Path path_of(std::uint32_t vertex, std::span<const glm::vec4> positions_t0,
                    std::span<const glm::vec4> positions_t1)
{
    return {glm::dvec3(positions_t0[vertex]), glm::dvec3(positions_t1[vertex])};
}

// Whether the point changes the side of the moving face a, b, c through its inside, edges included, an odd number of
// times. A point exactly on the plane of the face counts as on the side of its normal, so touching is no crossing, and
// two steps in a row agree on the pose between them. Without motion, or with a face without area, the answer is no.
bool passes_through(const Path& point, const Path& a, const Path& b, const Path& c);

// All of them from positions_t0 to positions_t1 (xyz [m]), in order of vertex and face. A vertex that goes exactly
// through an edge counts for both its faces. Begins `query` for itself, without culling.
std::vector<VertexFace> find_pass_through(ElementQuery& query, std::span<const glm::vec4> positions_t0,
                                          std::span<const glm::vec4> positions_t1, ThreadPool& pool);

}  // namespace nuno
