// Whether the pairs of an earlier query still hold: a query found with room to spare need not be done again until the
// room is used up.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tree/tree_node.h"
#include "core/archive.h"
#include "core/thread_pool.h"

namespace nuno {

// Say a query found all pairs that come within `found_within` of each other on a way, and at the start of a later way
// every vertex is displaced against the start of that one by a vector in a box of diagonal D at most, and at its end
// against the end of that one by a vector in another such box. At equal times of the two ways the displacements of two
// vertices differ by no more than D then, for they go from start to end in straight lines, and so do those of any two
// points of the cloth. So every pair that comes within `distance` on the later way came within distance + D on the
// first, and is in the list as long as distance + D <= found_within. Nothing needs to be known of the pairs, and the
// whole cloth may have moved any distance together.
class MotionBound
{
  public:
    // Remembers the query's way.
    void note_query(const Poses& poses, float found_within);
    // Some of the vertices instead, for little: their motion is that of all or less, and no query is covered.
    void note_some(const Poses& poses);
    void forget() { start_.clear(); }

    // Whether all pairs that come within `distance` [m] on this way are among those of the noted query.
    bool covers(const Poses& poses, float distance, ThreadPool& pool) const;

    // How far two vertices have moved against each other since the query, at most [m]; infinite without one.
    double relative_motion(const Poses& poses, ThreadPool& pool) const;

    // Writes what is remembered, or reads it.
    void carry(Archive& archive);

  private:
    void note(const Poses& poses, std::size_t step);

    std::size_t step_ = 1;                // between the vertices that are remembered
    std::vector<glm::vec4> start_, end_;  // of these
    float found_within_ = 0;
};

}  // namespace nuno
