// Smooth normals of a moving mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"

namespace nuno {

// A kernel that gathers, for each vertex, over its faces in their order.
class VertexNormals
{
  public:
    VertexNormals(std::span<const glm::uvec3> faces, std::uint32_t vertex_count);

    // Computes them for the positions (vec4, xyz used) in this buffer, after whatever kernels wrote those.
    void update(GLuint positions);

    // One vec4 a vertex, xyz of unit length; for draws, after barrier_compute_to_draw.
    const Buffer& buffer() const { return normals_; }

  private:
    Program program_;
    std::uint32_t vertex_count_;
    Buffer starts_, corners_, normals_;
    BufferTexture positions_view_, starts_view_, corners_view_;
};

// The same on the CPU, face by face: what the kernel is tested against.
std::vector<glm::vec3> smooth_normals(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces);

}  // namespace nuno
