// What passes of collision did, named as in the report.
#pragma once

#include <algorithm>
#include <cstdint>

namespace nuno {

struct CollisionCounts
{
    std::uint64_t pairs_tested = 0;  // of elements that may meet; at `spheres` of vertices in cells that touch
    std::uint64_t pairs_culled = 0;  // of elements of faces that share a vertex, proven apart and not looked at
    std::uint32_t contacts = 0;      // found, or foreseen
    std::uint32_t impacts = 0;       // in the first round of a pass
    std::uint32_t zones = 0;         // clusters that went back at once, of each pass the most
    std::uint32_t rollbacks = 0;     // rounds of going back
    std::uint32_t standstills = 0;   // passes in which all of the cloth went back to the start
    std::uint32_t largest_zone = 0;  // vertices of the largest cluster
    std::uint32_t held_back = 0;     // vertices on moving handles that went back: their motion has no room
    double lost_m = 0;               // sum over the vertices of how far answers to impacts moved them
    std::uint32_t touching = 0;      // pairs that touched as a pass began
    std::uint32_t unresolved = 0;    // impacts that were left, or passed through, if that was counted

    // Sums, but for the largest cluster and the most vertices held back.
    void add(const CollisionCounts& pass)
    {
        pairs_tested += pass.pairs_tested;
        pairs_culled += pass.pairs_culled;
        contacts += pass.contacts;
        impacts += pass.impacts;
        zones += pass.zones;
        rollbacks += pass.rollbacks;
        standstills += pass.standstills;
        largest_zone = std::max(largest_zone, pass.largest_zone);
        held_back = std::max(held_back, pass.held_back);
        lost_m += pass.lost_m;
        touching += pass.touching;
        unresolved += pass.unresolved;
    }
};

}  // namespace nuno
