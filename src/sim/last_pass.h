// What the last pass of self-collision of a run found, for pictures of it.
#pragma once

#include <span>

#include "collision/contact.h"
#include "collision/impact_zone.h"
#include "collision/sphere_pairs.h"
#include "model/layer_contact.h"
#include "model/sim_params.h"

namespace nuno {

// It lasts until the run goes on. A frame may have several passes, and one in which the cloth sleeps has none.
struct LastPass
{
    CollisionLevel level = CollisionLevel::none;  // at which it was made; none: there was none
    std::span<const Contact> contacts;            // at `discrete`
    std::span<const VertexPair> sphere_pairs;     // at `spheres`
    std::span<const LayerContact> foreseen;       // from `speculative` on, before it
    std::span<const Impact> impacts;              // from `continuous` on; a pair may be there more than once
};

}  // namespace nuno
