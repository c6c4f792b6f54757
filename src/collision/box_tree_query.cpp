// The self-query of the tree of boxes.
#include <bit>
#include <cassert>

#include "collision/box_tree.h"

namespace nuno {

void BoxTree::visit(NodePair pair, TreeQuery& state, Culling culling) const
{
    assert(culling != Culling::seed || culled_.size() == nodes_.size());
    ++state.visits;
    const Node& a = nodes_[pair.a];
    const Node& b = nodes_[pair.b];
    const bool within = pair.a == pair.b;
    if (within && culling == Culling::seed && culled_[pair.a]) {
        state.pairs_culled += std::uint64_t{a.face_count} * (a.end_vertex - a.first_vertex);
        return;
    }
    if (is_block(pair.a)) return state.found.push_back(pair);

    const unsigned from_a = within ? 0xfu : overlapping_children(a, boxes_[pair.b]);
    for (unsigned i = from_a; i != 0; i &= i - 1) {
        const int slot = std::countr_zero(i);
        if (a.child[slot] == kNoChild) break;
        const unsigned from_b = overlapping_children(b, boxes_[a.child[slot]]) & (within ? 0xfu << slot : 0xfu);
        for (unsigned j = from_b; j != 0; j &= j - 1)
            state.open.push_back({a.child[slot], b.child[std::countr_zero(j)]});
    }
}

void BoxTree::query(TreeQuery& state, Culling culling) const
{
    while (!state.open.empty()) {
        const NodePair pair = state.open.back();
        state.open.pop_back();
        visit(pair, state, culling);
    }
}

}  // namespace nuno
