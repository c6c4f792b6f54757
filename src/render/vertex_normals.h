// Smooth normals of a moving mesh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"

namespace nuno {

// With folds, w of a normal is how much the cloth bends towards it, as a mean curvature [1/m]; else 0.
enum class NormalKind
{
    plain,
    with_folds
};

// A kernel that gathers, for each vertex, over its faces in their order: smooth_normals on the device.
class VertexNormals
{
  public:
    VertexNormals(std::span<const glm::uvec3> faces, std::uint32_t vertex_count);

    // Makes the kernel of a kind, unless it is there.
    void prepare(NormalKind kind);

    // Computes them for the positions (vec4, xyz used) in this buffer, after whatever kernels wrote those.
    void update(GLuint positions, NormalKind kind);

    // One vec4 a vertex, xyz of unit length, w by the kind; for draws, after barrier_compute_to_draw.
    const Buffer& buffer() const { return normals_; }

  private:
    std::array<std::optional<Program>, 2> programs_;  // by kind, each made when first needed
    std::uint32_t vertex_count_;
    Buffer starts_, corners_, normals_;
    BufferTexture positions_view_, starts_view_, corners_view_;
};

}  // namespace nuno
