// The force of moving air on every vertex, as an acceleration that xpbd takes in with gravity.
#pragma once

#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "solver/base/cpu_faces.h"

namespace nuno {

class XpbdAir
{
  public:
    explicit XpbdAir(const ClothModel& model);

    // [m/s2], one a vertex, for this state (w of positions: inverse mass) at a time. Valid until the next call.
    std::span<const glm::vec3> accelerations(std::span<const glm::vec4> positions,
                                             std::span<const glm::vec4> velocities, const SimParams& params,
                                             double time_s, ThreadPool& pool);

  private:
    CpuFaces faces_;
    VertexLanes3 x_, v_;
    std::vector<glm::vec3> accelerations_;
};

}  // namespace nuno
