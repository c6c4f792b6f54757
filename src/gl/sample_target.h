// A picture of several samples a pixel that is drawn into and then read sample by sample.
#pragma once

#include "gl/gl.h"

namespace nuno {

class SampleTarget
{
  public:
    // RGBA8 colour and 24-bit depth, `width` x `height` pixels; `samples` is lowered to what the device can.
    // Error where the device cannot draw into a picture of this size.
    SampleTarget(int width, int height, int samples);
    ~SampleTarget();
    SampleTarget(const SampleTarget&) = delete;
    SampleTarget& operator=(const SampleTarget&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_; }

    // Draws go into it from now on, over all of it.
    void begin() const;
    // Binds its colours for a sampler2DMS whose binding is `unit`.
    void bind(GLuint unit) const;

  private:
    void destroy() const;

    int width_, height_, samples_ = 1;
    GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

}  // namespace nuno
