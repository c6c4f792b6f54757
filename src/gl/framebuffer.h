// A picture that is drawn off screen, with several samples a pixel, and read back.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/gl.h"

namespace nuno {

class Framebuffer
{
  public:
    // RGBA8 colour and 24-bit depth, `width` x `height` pixels; `samples` is lowered to what the device can.
    // Error where the device cannot draw into a picture of this size.
    Framebuffer(int width, int height, int samples);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_; }

    // The framebuffer that is drawn into.
    GLuint id() const { return drawn_.id; }

    // Averages the samples of what was drawn into the framebuffer resolved_id, which read_rgba reads.
    void resolve() const;
    GLuint resolved_id() const { return resolved_.id; }

    // Waits for the device and copies the resolved picture: 4 width height bytes, rows top-down.
    void read_rgba(std::vector<std::uint8_t>& pixels) const;

  private:
    struct Surface
    {
        GLuint id = 0, colour = 0, depth = 0;
    };
    static Surface make_surface(int width, int height, int samples, bool with_depth);
    static void destroy(const Surface& surface);

    Surface drawn_, resolved_;  // the same where there is one sample
    int width_ = 0, height_ = 0, samples_ = 1;
};

}  // namespace nuno
