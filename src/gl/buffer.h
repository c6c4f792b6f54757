// A buffer object: memory of the device that kernels write and draws read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gl/gl.h"

namespace nuno {

class Buffer
{
  public:
    Buffer() = default;  // no buffer: id 0
    // `initial` holds `bytes` bytes, or is null for undefined contents; `usage` is a hint such as GL_STATIC_DRAW.
    // Error where the driver has no room for it.
    Buffer(std::size_t bytes, const void* initial, GLenum usage);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    GLuint id() const { return id_; }
    std::size_t size_bytes() const { return bytes_; }

    // Replaces the bytes from `offset` [bytes] on. After kernels wrote the buffer: barrier_compute_to_upload first.
    void update(std::size_t offset, std::span<const std::byte> bytes);
    template <class T>
    void update(std::size_t offset, const std::vector<T>& values)
    {
        update(offset, std::as_bytes(std::span(values)));
    }

    // Waits for the device and copies out. After kernels wrote the buffer: barrier_compute_to_readback first.
    void read(std::size_t offset, std::span<std::byte> bytes) const;
    template <class T>
    void read(std::size_t offset, std::span<T> values) const
    {
        read(offset, std::as_writable_bytes(values));
    }

    // Copies `bytes` bytes from `offset` on to `to`, another buffer, on the device. After kernels wrote either:
    // barrier_compute_to_upload first.
    void copy_to(std::size_t offset, const Buffer& to, std::size_t to_offset, std::size_t bytes) const;

    // Binds the whole buffer to a numbered block: GL_SHADER_STORAGE_BUFFER or GL_UNIFORM_BUFFER.
    void bind_block(GLenum target, GLuint binding) const { glBindBufferBase(target, binding, id_); }

  private:
    GLuint id_ = 0;
    std::size_t bytes_ = 0;
};

// A buffer that holds a copy of `values`.
template <class T>
Buffer make_buffer(std::span<const T> values, GLenum usage)
{
    return Buffer(values.size_bytes(), values.data(), usage);
}
template <class T>
Buffer make_buffer(const std::vector<T>& values, GLenum usage)
{
    return make_buffer(std::span<const T>(values), usage);
}

}  // namespace nuno
