// Off-screen targets.
#include "gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace nuno {

Framebuffer::Framebuffer(int width, int height, int samples) : width_(width), height_(height)
{
    GLint most_samples = 1, most_pixels = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most_pixels);
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels)
        throw Error(
            fmt::format("OpenGL: a picture of {} x {} pixels cannot be drawn; each side is 1 to {} on this device",
                        width, height, most_pixels));
    samples_ = std::clamp(samples, 1, std::max(most_samples, 1));
    drawn_ = make_surface(width, height, samples_, true);
    resolved_ = samples_ > 1 ? make_surface(width, height, 1, false) : drawn_;
}

Framebuffer::~Framebuffer()
{
    if (resolved_.id != drawn_.id) destroy(resolved_);
    destroy(drawn_);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : drawn_(std::exchange(other.drawn_, {})),
      resolved_(std::exchange(other.resolved_, {})),
      width_(other.width_),
      height_(other.height_),
      samples_(other.samples_)
{
}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept
{
    std::swap(drawn_, other.drawn_);
    std::swap(resolved_, other.resolved_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(samples_, other.samples_);
    return *this;
}

void Framebuffer::resolve() const
{
    if (resolved_.id == drawn_.id) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::read_rgba(std::vector<std::uint8_t>& pixels) const
{
    const std::size_t row = 4 * static_cast<std::size_t>(width_);
    pixels.resize(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t low = 0, high = pixels.size() - row; low < high; low += row, high -= row)
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(low),
                         pixels.begin() + static_cast<std::ptrdiff_t>(low + row),
                         pixels.begin() + static_cast<std::ptrdiff_t>(high));
}

Framebuffer::Surface Framebuffer::make_surface(int width, int height, int samples, bool with_depth)
{
    // Zero samples asks for an ordinary, not a multisampled, renderbuffer.
    const GLsizei storage_samples = samples > 1 ? samples : 0;
    const auto make_storage = [&](GLenum format) {
        GLuint id = 0;
        glGenRenderbuffers(1, &id);
        glBindRenderbuffer(GL_RENDERBUFFER, id);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, storage_samples, format, width, height);
        return id;
    };
    Surface surface;
    glGenFramebuffers(1, &surface.id);
    glBindFramebuffer(GL_FRAMEBUFFER, surface.id);
    surface.colour = make_storage(GL_RGBA8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, surface.colour);
    if (with_depth) {
        surface.depth = make_storage(GL_DEPTH_COMPONENT24);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, surface.depth);
    }
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return surface;
    destroy(surface);
    throw Error(
        fmt::format("OpenGL: a picture of {} x {} pixels with {} samples cannot be drawn (status {:#x}); "
                    "give a smaller size or fewer samples",
                    width, height, samples, status));
}

void Framebuffer::destroy(const Surface& surface)
{
    glDeleteFramebuffers(1, &surface.id);
    glDeleteRenderbuffers(1, &surface.colour);
    glDeleteRenderbuffers(1, &surface.depth);
}

}  // namespace nuno
