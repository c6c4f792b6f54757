// The pairs of a query, found with room to spare, for later ones that ask for the same.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/face_elements.h"
#include "collision/tree/motion_bound.h"
#include "core/thread_pool.h"

namespace nuno {

class KeptPairs
{
  public:
    // Whether a query with these settings asks for what the last one did: nearly the same distance, otherwise alike.
    bool are_like(const TreeSettings& settings) const;

    // Measures how far the cloth has moved since the pairs were found; whether they hold all that the settings ask for
    // on this way. Call it once a query.
    bool hold(const Poses& poses, const TreeSettings& settings, ThreadPool& pool);

    // The margin [m] that a query now should have, by the motion measured last: enough for several queries to come, and
    // 0 where that is more than `most`.
    float margin_for(const TreeSettings& settings, float most) const;

    // Forgets the pairs for those that a query on this way is about to find; without a margin none are kept.
    void begin(const Poses& poses, const TreeSettings& settings);

    // Writes the pairs and all that says how long they hold, or reads them.
    void carry(Archive& archive);

    std::vector<ElementPair> pairs;
    std::uint64_t near_culled = 0;  // ElementQuery::near_pairs_culled

  private:
    MotionBound bound_;
    TreeSettings settings_;
    double motion_ = 0;  // [m] measured last, over `queries_`
    int queries_ = 0;    // since the pairs were found
};

}  // namespace nuno
