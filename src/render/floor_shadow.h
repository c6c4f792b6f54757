// The soft shadow that cloth and bodies cast on the floor.
#pragma once

#include "gl/program.h"
#include "gl/texture_target.h"
#include "gl/vertex_array.h"
#include "render/body_renderer.h"
#include "render/cloth_renderer.h"

namespace nuno {

class FloorShadow
{
  public:
    FloorShadow();

    // Draws what stands in the key light as seen from it, and softens it. Draws into its own texture, with the uniform
    // block View bound; the caller binds its framebuffer and viewport again.
    void update(const ClothRenderer& cloth, const BodyRenderer& bodies) const;

    // Binds the texture, 1 in full shadow, for a sampler2D whose binding is `unit`.
    void bind(GLuint unit) const { mask_.bind(unit); }

  private:
    void soften(const TextureTarget& from, const TextureTarget& to, glm::vec2 direction) const;

    Program cloth_, body_, blur_;
    TextureTarget mask_, between_;
    VertexArray no_vertices_;
};

}  // namespace nuno
