// How the vertices of a draw are read from buffers.
#pragma once

#include "gl/gl.h"

namespace nuno {

class VertexArray
{
  public:
    VertexArray();
    ~VertexArray();
    VertexArray(VertexArray&& other) noexcept;
    VertexArray& operator=(VertexArray&& other) noexcept;

    void bind() const { glBindVertexArray(id_); }

    // Attribute `location` is `components` floats at `offset` bytes of each element of buffer slot `slot`.
    void attribute(GLuint location, GLuint slot, GLint components, GLuint offset = 0);

    // Slot `slot` reads `buffer`, one element every `stride` bytes; may change before every draw.
    void vertices(GLuint slot, GLuint buffer, GLsizei stride);

    // Steps slot `slot` once an instance instead of once a vertex.
    void per_instance(GLuint slot);

    // Indices of the vertices of indexed draws.
    void indices(GLuint buffer);

  private:
    GLuint id_ = 0;
};

}  // namespace nuno
