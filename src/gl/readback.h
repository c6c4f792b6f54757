// A copy from the device that the CPU waits for only when it needs it.
#pragma once

#include <cstddef>
#include <span>

#include "gl/buffer.h"

namespace nuno {

class Readback
{
  public:
    Readback() = default;
    ~Readback();
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    // Copies the first `bytes` bytes of `buffer`, as all earlier kernels leave them, into a staging buffer, and returns
    // at once. A copy not yet finished is dropped.
    void begin(GLuint buffer, std::size_t bytes);

    // Waits for the copy of the last begin and hands it out; `bytes` is at most as long as it.
    // Error where the device was lost.
    void finish(std::span<std::byte> bytes);
    template <class T>
    void finish(std::span<T> values)
    {
        finish(std::as_writable_bytes(values));
    }

    bool pending() const { return fence_ != nullptr; }

  private:
    void drop_fence();

    Buffer staging_;
    std::size_t bytes_ = 0;
    GLsync fence_ = nullptr;
};

}  // namespace nuno
