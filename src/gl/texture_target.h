// A texture that is drawn into.
#pragma once

#include "gl/gl.h"

namespace nuno {

class TextureTarget
{
  public:
    // One 8-bit channel, `side` x `side` texels, filtered linearly; outside it reads 0.
    explicit TextureTarget(int side);
    ~TextureTarget();
    TextureTarget(const TextureTarget&) = delete;
    TextureTarget& operator=(const TextureTarget&) = delete;

    int side() const { return side_; }
    // Draws go into it from now on, over all of it.
    void begin() const;
    // Binds it for a sampler2D whose binding is `unit`.
    void bind(GLuint unit) const;

  private:
    int side_;
    GLuint texture_ = 0, framebuffer_ = 0;
};

}  // namespace nuno
