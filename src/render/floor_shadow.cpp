// Masks of the floor in the key light.
#include "render/floor_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

// Texels along a side: with the softening, a shadow as blurred as a large lamp makes it.
constexpr int kSide = 256;
// Both ways of the blur look 3.23 texels away, between two texels, and the floor between two again.
constexpr int kSoftTexels = 8;
// Where the penumbra may be narrow, and its levels down to a single texel.
constexpr int kMaskSide = 512, kMaskLevels = 10;

}  // namespace

PixelBox floor_shadow_pixels(const ViewBlock& block, std::span<const Bounds> casters, float reach_m, glm::ivec2 size)
{
    const glm::vec3 normal(block.floor_plane), key(block.key_direction), centre(block.shadow_centre);
    const glm::vec3 across(block.floor_across), along(block.floor_along);
    const float half_side = block.shadow_centre.w;
    glm::vec2 low(half_side), high(-half_side);
    for (const Bounds& box : casters)
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p = corner_of(box, corner);
            const glm::vec3 way =
                p - (glm::dot(normal, p) - block.floor_plane.w) / glm::dot(normal, key) * key - centre;
            const glm::vec2 at(glm::dot(way, across), glm::dot(way, along));
            if (!std::isfinite(at.x + at.y)) return {{0, 0}, size};
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    low = glm::max(low - reach_m, -half_side);
    high = glm::min(high + reach_m, half_side);
    if (!(low.x < high.x && low.y < high.y)) return {};
    std::array<Bounds, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 p = centre + (i & 1 ? high.x : low.x) * across + (i & 2 ? high.y : low.y) * along;
        corners[static_cast<std::size_t>(i)] = {p, p};
    }
    return pixels_of(corners, block.view_projection, size);
}

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

float FloorShadow::reach_m(float half_side_m) { return kSoftTexels * 2 * half_side_m / kSide; }

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

// Of floor_penumbra.glsl: its widest look is at texels as wide as the penumbra of the highest caster, or less than twice
// that, and between two of them.
float FloorMask::reach_m(float half_side_m, float light_size_deg)
{
    const float widest = std::tan(0.5f * glm::radians(light_size_deg)) * SHADOW_HEIGHT;
    return 3 * std::max(widest, 2 * half_side_m / kMaskSide);
}

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
