// A depth map that is drawn into and then read, compared or as it is.
#pragma once

#include "gl/gl.h"

namespace nuno {

class DepthTarget
{
  public:
    // `side` x `side` texels; outside it reads 1, the greatest depth.
    explicit DepthTarget(int side);
    ~DepthTarget();
    DepthTarget(const DepthTarget&) = delete;
    DepthTarget& operator=(const DepthTarget&) = delete;

    int side() const { return side_; }
    // Draws go into it from now on, over all of it.
    void begin() const;
    // Binds it for a sampler2DShadow, 1 where the reference is not the deeper, averaged over the four texels around.
    void bind_compared(GLuint unit) const;
    // Binds it for a sampler2D, the nearest texel.
    void bind_depth(GLuint unit) const;

  private:
    int side_;
    GLuint texture_ = 0, framebuffer_ = 0, compared_ = 0, depth_ = 0;
};

}  // namespace nuno
