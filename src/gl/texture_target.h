// A texture that is drawn into.
#pragma once

#include "gl/gl.h"

namespace nuno {

class TextureTarget
{
  public:
    // `side` x `side` texels of one 8-bit channel, or of another format, filtered linearly; outside it reads 0. With
    // `levels` above 1 its texels, then averages over 2 x 2 of them, over 4 x 4, and so on.
    explicit TextureTarget(int side, GLenum format = GL_R8, int levels = 1);
    ~TextureTarget();
    TextureTarget(const TextureTarget&) = delete;
    TextureTarget& operator=(const TextureTarget&) = delete;

    int side() const { return side_; }
    // Draws go into it from now on, over all of it.
    void begin() const;
    // Makes all levels but the first, of what was drawn.
    void make_levels() const;
    // Binds it for a sampler2D whose binding is `unit`.
    void bind(GLuint unit) const;

  private:
    int side_;
    GLuint texture_ = 0, framebuffer_ = 0;
};

}  // namespace nuno
