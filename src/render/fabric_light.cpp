// Maps and constants of one picture.
#include "render/fabric_light.h"

#include "render/fabric_block.h"
#include "render/sheen.h"
#include "render/weave_map.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

constexpr int kKeyMapSide = 1024;

}  // namespace

FabricLight::FabricLight()
    : cloth_depth_(draw_program("render/key_map_cloth.vert", "render/depth_alone.frag")),
      body_depth_(draw_program("render/key_map_body.vert", "render/depth_alone.frag")),
      key_map_(kKeyMapSide),
      weave_(kWeaveSide, kWeaveSide, weave_texels(), Texels::linear),
      block_(sizeof(FabricBlock), nullptr, GL_STREAM_DRAW)
{
}

void FabricLight::update(const ViewParams& params, float aspect, bool on_floor, const ClothRenderer& cloth,
                         const BodyRenderer& bodies)
{
    if (fitted_roughness_ != params.sheen_roughness) {
        sheen_fit_ = fit_sheen_albedo(params.sheen_roughness);
        fitted_roughness_ = params.sheen_roughness;
    }
    const FabricBlock block = make_fabric_block(params, aspect, kKeyMapSide, sheen_fit_);
    block_.update(0, std::as_bytes(std::span(&block, 1)));
    block_.bind_block(GL_UNIFORM_BUFFER, BLOCK_FABRIC);
    if (params.shadow) draw_key_map(cloth, bodies);
    if (on_floor) floor_.update(cloth, bodies);
    key_map_.bind_compared(UNIT_KEY_COMPARED);
    key_map_.bind_depth(UNIT_KEY_DEPTH);
    floor_.bind(UNIT_FLOOR_SHADOW);
    weave_.bind(UNIT_WEAVE);
}

void FabricLight::draw_key_map(const ClothRenderer& cloth, const BodyRenderer& bodies) const
{
    key_map_.begin();
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    // What lies beyond the map's depths still throws its shadow.
    glEnable(GL_DEPTH_CLAMP);
    cloth_depth_.use();
    cloth.draw_faces();
    body_depth_.use();
    bodies.draw_faces();
    glDisable(GL_DEPTH_CLAMP);
}

}  // namespace nuno
