// Writes meshes in motion: OBJ and PLY files of one frame, PC2 point caches of many.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// What a mesh file shows; positions are xyz [m], written with 9 significant digits, which give back the same floats.
struct MeshView
{
    std::span<const glm::vec4> positions;
    std::span<const glm::vec2> uvs;
    std::span<const glm::uvec3> faces;
};

std::string obj_text(const MeshView& mesh);
std::string ply_text(const MeshView& mesh);

// A PC2 point cache: 32 bytes of header, then the positions of every sample as little-endian floats.
class PointCache
{
  public:
    explicit PointCache(std::size_t point_count) : point_count_(point_count) {}
    void add(std::span<const glm::vec4> positions);
    // Error where it cannot be written; the file is whole or as it was before.
    void write(const std::filesystem::path& path) const;

  private:
    std::size_t point_count_;
    std::vector<glm::vec3> samples_;
};

}  // namespace nuno
