// A mesh whose rest shape is flat and convex: its surface as a map of the plane, and where that map is monotone.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tree/kernels.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

class RestChart
{
  public:
    // Nothing where the rest shape is not one flat sheet of faces without holes, whose rim is convex.
    static std::optional<RestChart> make(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                                         const Sheet& sheet);

    // Whether vertices are further than the settings ask from the faces that they are no corners of, and edges from
    // edges without a common end, all over the sheet at all times of the way (docs/tree.md).
    bool is_apart(const Poses& poses, std::span<const glm::uvec3> faces, const TreeSettings& settings,
                  const TreeKernels& kernels, ThreadPool& pool) const;

  private:
    std::uint32_t first_face_ = 0;
    std::vector<FaceChart> charts_;  // of each face
    double least_height_ = 0;        // [m] from a corner of a face to the opposite edge
    float slack_ = 0;                // TreeKernels::prove_blocks
};

}  // namespace nuno
