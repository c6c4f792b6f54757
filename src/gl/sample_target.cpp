// Multisample textures as targets.
#include "gl/sample_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace nuno {

SampleTarget::SampleTarget(int width, int height, int samples) : width_(width), height_(height)
{
    GLint most_colour = 1, most = 1;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &most_colour);
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    samples_ = std::clamp(samples, 1, std::max(std::min(most, most_colour), 1));
    glGenTextures(1, &colour_);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, colour_);
    // The same places in each pixel, as a picture with a renderbuffer needs.
    glTexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, GL_RGBA8, width, height, GL_TRUE);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &samples_);
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width, height);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, colour_, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    destroy();
    throw Error(
        fmt::format("OpenGL: a picture of {} x {} pixels with {} samples cannot be drawn (status {:#x}); "
                    "give a smaller size or fewer samples",
                    width, height, samples, status));
}

SampleTarget::~SampleTarget() { destroy(); }

void SampleTarget::destroy() const
{
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &colour_);
    glDeleteRenderbuffers(1, &depth_);
}

void SampleTarget::begin() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void SampleTarget::bind(GLuint unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, colour_);
}

}  // namespace nuno
