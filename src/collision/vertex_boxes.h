// The boxes that vertices sweep in a step, and whether those of two elements overlap.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/face_elements.h"
#include "collision/float4.h"

namespace nuno {

class VertexBoxes
{
  public:
    // From positions_t0 to positions_t1 [m], each box grown by `growth` [m] on every side.
    void set(std::span<const glm::vec4> positions_t0, std::span<const glm::vec4> positions_t1, float growth)
    {
        boxes_.resize(positions_t0.size());
        const Float4 margin = all_lanes(growth);
        for (std::size_t v = 0; v < boxes_.size(); ++v) {
            const Float4 a = lanes_of(positions_t0[v]), b = lanes_of(positions_t1[v]);
            boxes_[v] = {lesser(a, b) - margin, greater(a, b) + margin};
        }
    }

    // Whether the boxes around both elements overlap.
    bool overlap(const ElementPair& pair) const
    {
        const Box &a = boxes_[pair.vertices.x], &b = boxes_[pair.vertices.y], &c = boxes_[pair.vertices.z],
                  &d = boxes_[pair.vertices.w];
        const Box last = {lesser(c.lo, d.lo), greater(c.hi, d.hi)};
        const bool face = pair.kind == PairKind::vertex_face;
        const Box first = face ? a : Box{lesser(a.lo, b.lo), greater(a.hi, b.hi)};
        const Box second = face ? Box{lesser(b.lo, last.lo), greater(b.hi, last.hi)} : last;
        const unsigned lanes = lane_bits((first.lo <= second.hi) & (second.lo <= first.hi));
        return (lanes & 7u) == 7u;  // the fourth is no axis
    }

  private:
    struct Box
    {
        Float4 lo, hi;
    };
    std::vector<Box> boxes_;
};

}  // namespace nuno
