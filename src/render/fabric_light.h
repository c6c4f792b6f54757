// What the look `cloth` lights cloth with: the shadows in the key light, the threads, and the uniform block Fabric.
#pragma once

#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/depth_target.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/texture_target.h"
#include "render/body_renderer.h"
#include "render/cloth_renderer.h"
#include "render/floor_shadow.h"
#include "render/view_params.h"

namespace nuno {

class FabricLight
{
  public:
    FabricLight();

    // Draws the maps of one picture and binds all that the look's programs read, with the uniform block View bound.
    // `on_floor`: whether a shadow on the floor can be seen. The caller binds its framebuffer and viewport again.
    void update(const ViewParams& params, float aspect, bool on_floor, const ClothRenderer& cloth,
                const BodyRenderer& bodies);

  private:
    void draw_key_map(const ClothRenderer& cloth, const BodyRenderer& bodies) const;

    Program cloth_depth_, body_depth_;
    DepthTarget key_map_;
    FloorMask floor_;
    Texture weave_;
    Buffer block_;
    glm::vec4 sheen_fit_{0};
    float fitted_roughness_ = -1;
};

}  // namespace nuno
