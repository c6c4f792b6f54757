// `nuno render --check N`: looks at the poses of a run without taking part in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/element_query.h"
#include "collision/tangle.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

// Of all poses looked at.
struct CheckCounts
{
    int every = 0;  // frames; 0: no check
    std::uint64_t poses = 0;
    std::uint64_t crossing = 0, touching = 0;  // pairs of faces
    // Vertices and faces, on the straight way from the frame before: the way that was promised only where a frame has
    // one pass.
    std::uint64_t passed_through = 0;
    int first_frame = -1;  // with a finding; -1: none

    std::uint64_t intersections() const { return crossing + touching; }
};

// "nothing", or how many of each; whether every frame has one pass decides what that says.
std::string findings_text(const CheckCounts& counts, bool one_pass);

class PoseCheck
{
  public:
    // `model` must outlive it. Frames 0, every, 2 every, ... are looked at.
    PoseCheck(const ClothModel& model, int every, int threads);

    // Whether the pose of this frame is wanted: it is looked at, or it is the one before.
    bool wants(int frame) const { return frame % every_ == 0 || (frame + 1) % every_ == 0; }
    // Frames in order. What was found, as lines without the name of the scene; of many only the first.
    std::vector<std::string> look(int frame, const std::vector<glm::vec4>& positions);

    const CheckCounts& counts() const { return counts_; }

  private:
    const ClothModel& model_;
    int every_;
    ThreadPool pool_;
    TangleSearch search_;
    ElementQuery query_;
    std::vector<glm::vec4> before_;
    int before_frame_ = -1;
    CheckCounts counts_;
};

}  // namespace nuno
