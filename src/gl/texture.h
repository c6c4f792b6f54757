// A picture on the device.
#pragma once

#include <cstdint>
#include <span>

#include "gl/gl.h"

namespace nuno {

// What the bytes of a texture are: colours, or parts of 1.
enum class Texels
{
    srgb,
    linear
};

class Texture
{
  public:
    Texture() = default;  // no texture: id 0
    // `rgba` holds 4 width height bytes, rows bottom-up; it repeats in both directions and has mipmaps.
    Texture(int width, int height, std::span<const std::uint8_t> rgba, Texels texels = Texels::srgb);
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
