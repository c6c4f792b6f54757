// Buffers as textures.
#include "gl/buffer_texture.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "core/error.h"

namespace nuno {
namespace {

std::size_t texel_bytes(GLenum format)
{
    switch (format) {
    case GL_R32F:
    case GL_R32I:
    case GL_R32UI: return 4;
    case GL_RG32F:
    case GL_RG32I:
    case GL_RG32UI: return 8;
    case GL_RGBA32F:
    case GL_RGBA32I:
    case GL_RGBA32UI: return 16;
    default: assert(!"a texel of 1, 2 or 4 words of 32 bits"); return 4;
    }
}

// A unit that no kernel reads (OpenGL 4.3 has at least 96), so that what is bound for kernels stays bound.
constexpr GLuint kViewUnit = 95;

}  // namespace

BufferTexture::BufferTexture(GLenum format) : format_(format) { glGenTextures(1, &id_); }

BufferTexture::~BufferTexture() { glDeleteTextures(1, &id_); }

BufferTexture::BufferTexture(BufferTexture&& other) noexcept : id_(std::exchange(other.id_, 0)), format_(other.format_)
{
}

BufferTexture& BufferTexture::operator=(BufferTexture&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(format_, other.format_);
    return *this;
}

void BufferTexture::view(GLuint buffer, std::size_t bytes)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    const std::size_t texels = bytes / texel_bytes(format_);
    if (texels > static_cast<std::size_t>(most))
        throw Error(
            fmt::format("OpenGL: {} texels of a buffer are needed, but this device views at most {} at once; "
                        "lower the resolution or use the cpu backend",
                        texels, most));
    glActiveTexture(GL_TEXTURE0 + kViewUnit);
    glBindTexture(GL_TEXTURE_BUFFER, id_);
    glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer);
}

void BufferTexture::bind(GLuint unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, id_);
}

void BufferTexture::bind_image(GLuint unit) const
{
    glBindImageTexture(unit, id_, 0, GL_FALSE, 0, GL_READ_ONLY, format_);
}

}  // namespace nuno
