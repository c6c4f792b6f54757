// Whether the pairs of an earlier query still hold: a query found with room to spare need not be done again until the
// room is used up.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tree/tree_node.h"
#include "core/thread_pool.h"

namespace nuno {

// Say a query found all pairs that come within `found_within` of each other between the poses t0 and t1. At a later
// pose let every vertex have moved by a vector in a box of diagonal D, measured from t0. Two points of the cloth have
// then moved against each other by at most D since t0. So every pair that is now within `distance` was within distance
// + D at t0, and is in the list as long as distance + D <= found_within. A straight way between two such poses stays
// within the box too. Nothing needs to be known of the pairs, and the whole cloth may have moved any distance together.
class MotionBound
{
  public:
    // Remembers where the query's way began.
    void note_query(const Poses& poses, float found_within);
    void forget() { start_.clear(); }

    // Whether all pairs that come within `distance` [m] on this way are among those of the noted query.
    bool covers(const Poses& poses, float distance, ThreadPool& pool) const;

    // How far two vertices have moved against each other since the query, at most [m]; infinite without one.
    double relative_motion(const Poses& poses, ThreadPool& pool) const;

  private:
    std::vector<glm::vec4> start_;
    float found_within_ = 0;
};

}  // namespace nuno
