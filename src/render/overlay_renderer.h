// Draws overlays: marks as small quads that face the eye, and the cloth in the colours of numbers.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "gl/buffer.h"
#include "gl/buffer_texture.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "render/cloth_renderer.h"
#include "render/overlay.h"

namespace nuno {

class OverlayRenderer
{
  public:
    OverlayRenderer();

    // Draws `cloth` in the colours of these numbers, which are not empty, lit a little so that folds are seen. The
    // uniform block View must be bound, also below.
    void draw_cloth(const ClothHeat& heat, const ClothRenderer& cloth);

    // Draws the marks over a picture of `size` [pixels] that holds cloth and bodies with their depth. Leaves blending
    // off, and depth tested and written.
    void draw_marks(const Overlay& overlay, glm::ivec2 size);

  private:
    void draw(std::span<const Mark> marks, bool with_hidden);

    Program heat_program_, mark_program_;
    VertexArray vertices_;
    Buffer marks_, heat_;
    BufferTexture heat_view_;
};

}  // namespace nuno
