// Marks and numbers on the device.
#include "render/overlay_renderer.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

constexpr GLuint kMarkSlot = 0;
constexpr float kReferenceHeight = 720;  // of a picture whose pixels the widths are in
constexpr float kLeastScale = 0.6f;      // of widths in smaller ones
constexpr float kHiddenStrength = 0.3f;  // of marks that something lies before

// Storage that only grows.
void store(Buffer& buffer, std::span<const std::byte> bytes)
{
    if (buffer.size_bytes() < bytes.size()) buffer = Buffer(bytes.size(), nullptr, GL_STREAM_DRAW);
    buffer.update(0, bytes);
}

}  // namespace

OverlayRenderer::OverlayRenderer()
    : heat_program_(draw_program("render/cloth_heat.vert", "render/cloth_heat.frag")),
      mark_program_(draw_program("render/mark.vert", "render/mark.frag")),
      heat_view_(GL_R32F)
{
    vertices_.attribute(ATTRIBUTE_MARK_FROM, kMarkSlot, 4, offsetof(Mark, from));
    vertices_.attribute(ATTRIBUTE_MARK_TO, kMarkSlot, 4, offsetof(Mark, to));
    vertices_.attribute(ATTRIBUTE_MARK_COLOUR, kMarkSlot, 4, offsetof(Mark, colour));
    vertices_.per_instance(kMarkSlot);
}

void OverlayRenderer::draw_cloth(const ClothHeat& heat, const ClothRenderer& cloth)
{
    assert(!heat.values.empty());
    store(heat_, std::as_bytes(std::span(heat.values)));
    heat_view_.view(heat_.id(), heat.values.size() * sizeof(float));
    heat_view_.bind(UNIT_HEAT);
    heat_program_.set(LOCATION_HEAT_OF_FACES, std::int32_t{heat.is_of_faces});
    heat_program_.use();
    cloth.draw_faces();
}

void OverlayRenderer::draw_marks(const Overlay& overlay, glm::ivec2 size)
{
    if (overlay.on_cloth.empty() && overlay.through.empty()) return;
    mark_program_.set(LOCATION_PICTURE_SIZE, glm::vec2(size));
    mark_program_.set(LOCATION_MARK_SCALE, std::max(kLeastScale, float(size.y) / kReferenceHeight));
    mark_program_.use();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    // Colours of a layer that is laid over the rest are the covered part's, times how much is covered.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw(overlay.on_cloth, false);
    draw(overlay.through, true);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

void OverlayRenderer::draw(std::span<const Mark> marks, bool with_hidden)
{
    if (marks.empty()) return;
    store(marks_, std::as_bytes(marks));
    vertices_.vertices(kMarkSlot, marks_.id(), sizeof(Mark));
    vertices_.bind();
    const auto count = static_cast<GLsizei>(marks.size());
    if (with_hidden) {
        glDepthFunc(GL_GREATER);
        mark_program_.set(LOCATION_MARK_STRENGTH, kHiddenStrength);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
    glDepthFunc(GL_LEQUAL);
    mark_program_.set(LOCATION_MARK_STRENGTH, 1.0f);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

}  // namespace nuno
