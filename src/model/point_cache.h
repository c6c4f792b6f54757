// PC2 point caches: the vertices of a mesh in every frame, for programs that read them beside an OBJ file.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/whole_file.h"

namespace nuno {

// 32 bytes of header, then the positions of every sample as little-endian floats. Samples go to the disk as they come.
class PointCache
{
  public:
    // Error naming the path where it cannot be written, here as in the calls below.
    PointCache(const std::filesystem::path& path, std::size_t point_count);
    // One sample, xyz [m] of every point.
    void add(std::span<const glm::vec4> positions);
    // The file is there from now on, with the samples so far. Without this call it is as it was before.
    void finish();

  private:
    WholeFile file_;
    std::vector<glm::vec3> sample_;
    std::int32_t sample_count_ = 0;
};

}  // namespace nuno
