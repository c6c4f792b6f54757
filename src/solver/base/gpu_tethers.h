// Tethers as kernels that include sim/tethers.glsl read them.
#pragma once

#include <span>
#include <vector>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "model/tethers.h"

namespace nuno {

class GpuTethers
{
  public:
    GpuTethers();
    // Tethers as PinTethers has them, some at least.
    void upload(std::span<const Tether> tethers);
    void bind() const;

  private:
    Buffer anchor_buffer_, length_buffer_;
    BufferTexture anchors_, lengths_;
};

}  // namespace nuno
