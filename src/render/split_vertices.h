// Vertices drawn twice, where a texture has a seam.
#pragma once

#include <cstdint>
#include <span>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"

namespace nuno {

// Buffers of all vertices and, after them, of the copies; a kernel fills them anew for each picture.
class SplitVertices
{
  public:
    // `copies`: the vertex that each is of.
    SplitVertices(std::span<const std::uint32_t> copies, std::uint32_t vertex_count);

    // Takes over positions and normals (a vec4 a vertex) from these buffers, after whatever kernels wrote them.
    void update(GLuint positions, GLuint normals);

    // A vec4 each; for draws, after barrier_compute_to_draw.
    GLuint positions() const { return positions_.id(); }
    GLuint normals() const { return normals_.id(); }

  private:
    Program program_;
    std::uint32_t vertex_count_, drawn_count_;
    Buffer sources_, positions_, normals_;
    BufferTexture sources_view_, positions_view_, normals_view_;
};

}  // namespace nuno
