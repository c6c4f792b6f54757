// A buffer seen as a samplerBuffer: kernels gather through texelFetch, which is faster than reading a storage block.
#pragma once

#include <cstddef>

#include "gl/gl.h"

namespace nuno {

class BufferTexture
{
  public:
    // A view whose texels are of `format`, one of GL_R32F, GL_RG32F, GL_RGBA32F and their I and UI kin.
    explicit BufferTexture(GLenum format);
    ~BufferTexture();
    BufferTexture(BufferTexture&& other) noexcept;
    BufferTexture& operator=(BufferTexture&& other) noexcept;

    // Shows `buffer`, which is `bytes` long, from now on. Cheap enough for every frame.
    // Error where it has more texels than the device can view.
    void view(GLuint buffer, std::size_t bytes);

    // Binds it for a samplerBuffer whose binding is `unit`.
    void bind(GLuint unit) const;
    // Binds it for a readonly imageBuffer whose binding is `unit`: one that reads what the same dispatch writes.
    void bind_image(GLuint unit) const;

  private:
    GLuint id_ = 0;
    GLenum format_;
};

}  // namespace nuno
