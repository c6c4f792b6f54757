// Buffer objects.
#include "gl/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/error.h"

namespace nuno {

Buffer::Buffer(std::size_t bytes, const void* initial, GLenum usage) : bytes_(bytes)
{
    glGenBuffers(1, &id_);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id_);
    // A buffer without storage cannot be bound to a block of a program.
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 16)),
                 bytes >= 16 ? initial : nullptr, usage);
    GLint64 given = 0;
    glGetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &given);
    if (static_cast<std::size_t>(given) < bytes) {
        glDeleteBuffers(1, &id_);
        throw Error(
            fmt::format("OpenGL: the device has no room for a buffer of {} bytes; lower the resolution", bytes));
    }
    if (initial && bytes > 0 && bytes < 16)
        glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), initial);
}

Buffer::~Buffer() { glDeleteBuffers(1, &id_); }

Buffer::Buffer(Buffer&& other) noexcept : id_(std::exchange(other.id_, 0)), bytes_(std::exchange(other.bytes_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

void Buffer::update(std::size_t offset, std::span<const std::byte> bytes)
{
    assert(offset + bytes.size() <= bytes_);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id_);
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                    bytes.data());
}

void Buffer::read(std::size_t offset, std::span<std::byte> bytes) const
{
    assert(offset + bytes.size() <= bytes_);
    glBindBuffer(GL_COPY_READ_BUFFER, id_);
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                       bytes.data());
}

void Buffer::copy_to(std::size_t offset, const Buffer& to, std::size_t to_offset, std::size_t bytes) const
{
    assert(offset + bytes <= bytes_ && to_offset + bytes <= to.bytes_);
    glBindBuffer(GL_COPY_READ_BUFFER, id_);
    glBindBuffer(GL_COPY_WRITE_BUFFER, to.id_);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset),
                        static_cast<GLintptr>(to_offset), static_cast<GLsizeiptr>(bytes));
}

}  // namespace nuno
