// The shadow that cloth and bodies cast on the floor, as a map of the floor.
#pragma once

#include "gl/program.h"
#include "gl/texture_target.h"
#include "gl/vertex_array.h"
#include "render/body_renderer.h"
#include "render/cloth_renderer.h"
#include "render/pixel_box.h"
#include "render/view_block.h"

namespace nuno {

// Every pixel on which the floor can be darker than without the casters, which lie within the boxes; a shadow reaches
// `reach_m` further than they do in the key light. Of a picture of `size` pixels.
PixelBox floor_shadow_pixels(const ViewBlock& block, std::span<const Bounds> casters, float reach_m, glm::ivec2 size);

// Draws what stands in the key light as the floor sees it, shaders/render/shadow.frag.
class FloorCasters
{
  public:
    FloorCasters();

    // Over what `target` holds, with the uniform block View bound and without depth.
    void draw(const TextureTarget& target, const ClothRenderer& cloth, const BodyRenderer& bodies) const;

  private:
    Program cloth_, body_;
};

// Softened alike everywhere.
class FloorShadow
{
  public:
    FloorShadow();

    // Draws into its own texture, with the uniform block View bound; the caller binds its framebuffer and viewport
    // again.
    void update(const ClothRenderer& cloth, const BodyRenderer& bodies) const;

    // How far softening spreads a shadow [m], in a square of floor whose half side is `half_side_m`.
    static float reach_m(float half_side_m);
    // Binds the texture, 1 in full shadow, for a sampler2D whose binding is `unit`.
    void bind(GLuint unit) const { mask_.bind(unit); }

  private:
    void soften(const TextureTarget& from, const TextureTarget& to, glm::vec2 direction) const;

    FloorCasters casters_;
    Program blur_;
    TextureTarget mask_, between_;
    VertexArray no_vertices_;
};

// Not softened, but with its averages over wider and wider squares, and how high its casters stand: what
// shaders/render/floor_penumbra.glsl reads.
class FloorMask
{
  public:
    FloorMask();
    void update(const ClothRenderer& cloth, const BodyRenderer& bodies) const;
    void bind(GLuint unit) const { mask_.bind(unit); }
    // How far the penumbra of a lamp of `light_size_deg` can spread a shadow [m], in such a square.
    static float reach_m(float half_side_m, float light_size_deg);

  private:
    FloorCasters casters_;
    TextureTarget mask_;
};

}  // namespace nuno
