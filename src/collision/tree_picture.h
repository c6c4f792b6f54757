// The collision tree of a cloth as it is now, for pictures: apart from the tree that a run asks, which may be that of an
// earlier pose, and makes no boxes where it has proven that nothing touches.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/tree/face_tree.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

class TreePicture
{
  public:
    // Builds a tree of the cloth's own.
    explicit TreePicture(const ClothModel& model) : tree_(model), pool_(1) {}

    // Levels below the root.
    int depth() const { return tree_.depth(); }

    // Boxes that together hold all of the cloth at these positions (xyz [m], finite), so many levels below the root, at
    // most depth(), each larger by half of `distance` [m] on every side.
    std::vector<FaceBox> boxes(std::span<const glm::vec4> positions, float distance, int depth);

    // FaceTree::left_out of a query at these positions.
    std::vector<int> left_out(std::span<const glm::vec4> positions, const TreeSettings& settings);

  private:
    FaceTree tree_;
    ThreadPool pool_;
};

// What a pass of self-collision asks the tree for the contacts of cloth at these positions, as if it stood still.
// Only of levels that have a tree, from `discrete` on.
TreeSettings contact_query(const SimParams& params, std::span<const glm::uvec3> faces,
                           std::span<const glm::vec4> positions);

}  // namespace nuno
