// Depth textures as targets, read through two samplers.
#include "gl/depth_target.h"

#include <cassert>

namespace nuno {
namespace {

GLuint make_sampler(GLint filter, GLint compare)
{
    GLuint id = 0;
    glGenSamplers(1, &id);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const GLfloat outside[] = {1, 1, 1, 1};
    glSamplerParameterfv(id, GL_TEXTURE_BORDER_COLOR, outside);
    glSamplerParameteri(id, GL_TEXTURE_COMPARE_MODE, compare);
    glSamplerParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    return id;
}

}  // namespace

DepthTarget::DepthTarget(int side)
    : side_(side),
      compared_(make_sampler(GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE)),
      depth_(make_sampler(GL_NEAREST, GL_NONE))
{
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, side, side);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    // A format that every device draws into.
    assert(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

DepthTarget::~DepthTarget()
{
    glDeleteSamplers(1, &compared_);
    glDeleteSamplers(1, &depth_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void DepthTarget::begin() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, side_, side_);
}

void DepthTarget::bind_compared(GLuint unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glBindSampler(unit, compared_);
}

void DepthTarget::bind_depth(GLuint unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glBindSampler(unit, depth_);
}

}  // namespace nuno
