// Masks of the floor in the key light.
#include "render/floor_shadow.h"

#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

// Texels along a side: with the softening, a shadow as blurred as a large lamp makes it.
constexpr int kSide = 256;
// Where the penumbra may be narrow, and its levels down to a single texel.
constexpr int kMaskSide = 512, kMaskLevels = 10;

}  // namespace

FloorCasters::FloorCasters()
    : cloth_(draw_program("render/shadow_cloth.vert", "render/shadow.frag")),
      body_(draw_program("render/shadow_body.vert", "render/shadow.frag"))
{
}

void FloorCasters::draw(const TextureTarget& target, const ClothRenderer& cloth, const BodyRenderer& bodies) const
{
    glDisable(GL_DEPTH_TEST);
    target.begin();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    cloth_.use();
    cloth.draw_faces();
    body_.use();
    bodies.draw_faces();
}

FloorShadow::FloorShadow()
    : blur_(draw_program("render/whole_picture.vert", "render/blur.frag")), mask_(kSide), between_(kSide)
{
}

void FloorShadow::update(const ClothRenderer& cloth, const BodyRenderer& bodies) const
{
    casters_.draw(mask_, cloth, bodies);
    soften(mask_, between_, {1, 0});
    soften(between_, mask_, {0, 1});
}

void FloorShadow::soften(const TextureTarget& from, const TextureTarget& to, glm::vec2 direction) const
{
    to.begin();
    from.bind(UNIT_BLUR_SOURCE);
    blur_.set(LOCATION_BLUR_STEP, direction / float(kSide));
    blur_.use();
    no_vertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

FloorMask::FloorMask() : mask_(kMaskSide, GL_RG8, kMaskLevels) {}

void FloorMask::update(const ClothRenderer& cloth, const BodyRenderer& bodies) const
{
    // Of casters over each other the one nearest to the floor counts: its shadow is the sharper.
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    casters_.draw(mask_, cloth, bodies);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    mask_.make_levels();
}

}  // namespace nuno
