// What pictures show of the tree of faces: its boxes, and what it leaves out.
#include <algorithm>
#include <cassert>

#include "collision/tree/face_tree.h"

namespace nuno {
namespace {

// Whole steps of a box as metres. They were cut towards zero, so a step more on every side holds what was boxed.
FaceBox box_of(const TreeNode& node, const BoxFrame& frame)
{
    FaceBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        std::int16_t lo = kNothingLo, hi = kNothingHi;
        for (int child = 0; child < 4; ++child) {
            lo = std::min(lo, node.box[axis][child]);
            hi = std::max(hi, node.box[axis + 3][child]);
        }
        box.lo[axis] = frame.centre[a] + static_cast<float>(lo - 1) / frame.scale[a];
        box.hi[axis] = frame.centre[a] + static_cast<float>(hi + 1) / frame.scale[a];
    }
    return box;
}

}  // namespace

std::vector<FaceBox> FaceTree::node_boxes(int depth) const
{
    assert(depth >= 0 && depth <= this->depth());
    std::vector<FaceBox> boxes;
    for (const TreeNode& node : layout_.levels[static_cast<std::size_t>(this->depth() - depth)]) {
        const FaceBox box = box_of(node, frame_);
        // Nodes that fill a level up to fours are empty.
        if (box.lo.x <= box.hi.x) boxes.push_back(box);
    }
    return boxes;
}

std::vector<int> FaceTree::left_out() const
{
    const int level_count = depth() + 1;
    std::vector<int> of_face(faces_.size(), level_count);
    if (proven_apart_) return of_face;
    for (std::uint32_t c = 0; c < layout_.cells.size(); ++c) {
        const Cell& cell = layout_.cells[c];
        if (cell.is_absent()) continue;
        int level = level_count - 1;
        while (level >= 0 && !skips_self(level, c >> (2 * (level + 1)))) --level;
        for (const std::uint32_t face : cell.face)
            of_face[face] = level >= 0 ? level + 1 : int{is_apart_from_neighbours(face)};
    }
    return of_face;
}

}  // namespace nuno
