// The self-query of Embree, as a peer of nuno's tree.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/face_tree.h"

namespace nuno {

// Faces as user primitives with given boxes: refitted, then rtcCollide of the scene with itself, whose callback keeps
// the pairs a < b whose boxes overlap and that share no vertex.
class EmbreeCollide
{
  public:
    // `boxes` must outlive this.
    EmbreeCollide(std::span<const glm::uvec3> faces, const std::vector<FaceBox>& boxes, int thread_count);
    ~EmbreeCollide();

    void refit();
    void query();
    // Those of all threads, put together by the query.
    std::span<const FacePair> pairs() const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace nuno
