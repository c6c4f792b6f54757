// Buffers that kernels read through a buffer texture: tables that the CPU makes, and vectors that kernels write.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"

namespace nuno {

class GpuTable
{
  public:
    explicit GpuTable(GLenum format) : texture_(format) {}

    // Holds a copy of `values` from now on. Error where they are more than this device can view.
    void upload(std::span<const std::byte> values);
    template <class T>
    void upload(const std::vector<T>& values)
    {
        upload(std::as_bytes(std::span(values)));
    }

    // Binds it for a samplerBuffer whose binding is `unit`.
    void bind(GLuint unit) const { texture_.bind(unit); }

  private:
    Buffer buffer_;
    BufferTexture texture_;
};

// A vec4 for each vertex that kernels write as a storage block and read as a buffer texture.
struct VertexBuffer
{
    explicit VertexBuffer(std::size_t vertex_count);
    Buffer buffer;
    BufferTexture texture;
};

}  // namespace nuno
