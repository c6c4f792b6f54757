// Staging buffer and fence.
#include "gl/readback.h"

#include <fmt/format.h>

#include <cassert>
#include <cstring>

#include "core/error.h"
#include "gl/barriers.h"

namespace nuno {
namespace {

constexpr GLuint64 kSecondInNanoseconds = 1'000'000'000;

[[noreturn]] void throw_lost(const char* what)
{
    throw Error(fmt::format("OpenGL: {}; the device was lost or reset, so start again", what), ExitCode::went_bad);
}

void wait_for(GLsync fence)
{
    for (;;) {
        const GLenum status = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kSecondInNanoseconds);
        if (status == GL_ALREADY_SIGNALED || status == GL_CONDITION_SATISFIED) return;
        if (status == GL_WAIT_FAILED) throw_lost("waiting for a copy failed");
    }
}

}  // namespace

Readback::~Readback() { drop_fence(); }

void Readback::begin(GLuint buffer, std::size_t bytes)
{
    drop_fence();
    if (staging_.size_bytes() < bytes) staging_ = Buffer(bytes, nullptr, GL_STREAM_READ);
    bytes_ = bytes;
    barrier_compute_to_readback();
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, staging_.id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence_) throw_lost("a fence could not be placed");
    // The device starts now, while the CPU does other work.
    glFlush();
}

void Readback::finish(std::span<std::byte> bytes)
{
    assert(pending() && bytes.size() <= bytes_);
    wait_for(fence_);
    drop_fence();
    if (bytes.empty()) return;
    glBindBuffer(GL_COPY_READ_BUFFER, staging_.id());
    const void* from = glMapBufferRange(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), GL_MAP_READ_BIT);
    if (!from) throw_lost("a staging buffer could not be mapped");
    std::memcpy(bytes.data(), from, bytes.size());
    if (!glUnmapBuffer(GL_COPY_READ_BUFFER)) throw_lost("a staging buffer lost its contents");
}

void Readback::drop_fence()
{
    if (fence_) glDeleteSync(fence_);
    fence_ = nullptr;
}

}  // namespace nuno
