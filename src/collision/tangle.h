// Faces that intersect in one pose of the cloth, exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_meeting.h"
#include "collision/tree/face_tree.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

struct Tangle
{
    FacePair faces;  // a < b
    FaceMeeting meeting;
    glm::vec3 place;  // [m] where an edge goes through, or about where they touch
};

class TangleSearch
{
  public:
    // Rest positions [m] and faces of all sheets together; without sheets, all faces are one mesh.
    TangleSearch(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                 std::span<const Sheet> sheets);
    explicit TangleSearch(const ClothModel& model);

    // All pairs of faces that meet as in collision/face_meeting.h, in order; whatever the number of threads. Positions
    // (xyz [m]) are taken as the floats that they are; they must be finite and below 1e6 m.
    std::vector<Tangle> find(std::span<const glm::vec4> positions, ThreadPool& pool);

    std::span<const glm::uvec3> faces() const { return tree_.faces(); }

  private:
    FaceTree tree_;
    std::vector<FacePair> neighbours_;  // faces with a common vertex, which are in no list of the tree
};

// How many of them cross, and how many only touch.
struct TangleCounts
{
    std::uint64_t crossing = 0, touching = 0;
    std::uint64_t all() const { return crossing + touching; }
};
TangleCounts count_of(std::span<const Tangle> tangles);

// The number of the vertex at a corner of a crossing's edge: end 0 or 1.
std::uint32_t edge_vertex(const Tangle& tangle, const Crossing& crossing, int end, std::span<const glm::uvec3> faces);

}  // namespace nuno
