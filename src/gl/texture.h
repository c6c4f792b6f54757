// A picture on the device.
#pragma once

#include <cstdint>
#include <span>

#include "gl/gl.h"

namespace nuno {

class Texture
{
  public:
    Texture() = default;  // no texture: id 0
    // `rgba` holds 4 width height bytes, rows bottom-up; it repeats in both directions and has mipmaps.
    Texture(int width, int height, std::span<const std::uint8_t> rgba);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    GLuint id() const { return id_; }
    // Binds it for a sampler2D whose binding is `unit`.
    void bind(GLuint unit) const;

  private:
    GLuint id_ = 0;
};

// The most texels that this device accepts along a side.
int max_texture_size();

}  // namespace nuno
