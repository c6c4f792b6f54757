// Vertex array objects.
#include "gl/vertex_array.h"

#include <utility>

namespace nuno {

VertexArray::VertexArray() { glGenVertexArrays(1, &id_); }

VertexArray::~VertexArray() { glDeleteVertexArrays(1, &id_); }

VertexArray::VertexArray(VertexArray&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept
{
    std::swap(id_, other.id_);
    return *this;
}

void VertexArray::attribute(GLuint location, GLuint slot, GLint components, GLuint offset)
{
    bind();
    glEnableVertexAttribArray(location);
    glVertexAttribFormat(location, components, GL_FLOAT, GL_FALSE, offset);
    glVertexAttribBinding(location, slot);
}

void VertexArray::vertices(GLuint slot, GLuint buffer, GLsizei stride)
{
    bind();
    glBindVertexBuffer(slot, buffer, 0, stride);
}

void VertexArray::per_instance(GLuint slot)
{
    bind();
    glVertexBindingDivisor(slot, 1);
}

void VertexArray::indices(GLuint buffer)
{
    bind();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
}

}  // namespace nuno
