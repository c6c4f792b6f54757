// The order of one picture: normals, shadows, what stands around, and over it cloth and bodies.
#include "render/scene_view.h"

#include <cassert>
#include <vector>

#include <glm/geometric.hpp>

#include "gl/barriers.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

// The state that the draws rely on, whatever a window's other parts left.
void begin_picture(const Viewport& viewport)
{
    glBindFramebuffer(GL_FRAMEBUFFER, viewport.framebuffer);
    glViewport(0, 0, viewport.width, viewport.height);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

NormalKind normals_of(Look look) { return look == Look::cloth ? NormalKind::with_folds : NormalKind::plain; }

}  // namespace

void SceneView::prepare(Look look)
{
    std::optional<LookPrograms>& programs = programs_[static_cast<std::size_t>(look)];
    if (!programs) programs = make_look_programs(look);
    cloth_.prepare(normals_of(look));
    if (look == Look::cloth && !fabric_light_) fabric_light_.emplace();
    if (look != Look::cloth && !floor_shadow_) floor_shadow_.emplace();
}

// Draws the maps of shadows that the look reads, and binds them.
void SceneView::cast_shadows(const ViewParams& params, const ViewBlock& block, float aspect)
{
    const bool on_floor = params.floor && block.shadow_centre.w > 0;
    if (params.look == Look::cloth) return fabric_light_->update(params, aspect, on_floor, cloth_, bodies_);
    if (on_floor) floor_shadow_->update(cloth_, bodies_);
    floor_shadow_->bind(UNIT_FLOOR_SHADOW);
}

// Of cloth and bodies; none where the cloth's are not known on the host.
std::optional<std::vector<Bounds>> SceneView::figure_bounds() const
{
    const std::optional<Bounds> cloth = cloth_.bounds();
    if (!cloth) return std::nullopt;
    std::vector<Bounds> boxes(bodies_.bounds().begin(), bodies_.bounds().end());
    boxes.push_back(*cloth);
    return boxes;
}

// Where floor and background are not as without cloth and bodies.
PixelBox SceneView::shadow_pixels(const ViewParams& params, const ViewBlock& block, glm::ivec2 size) const
{
    const float half_side = block.shadow_centre.w;
    if (!params.floor || half_side == 0) return {};
    const auto boxes = figure_bounds();
    if (!boxes) return {{0, 0}, size};
    const float reach_m =
        params.look == Look::cloth ? FloorMask::reach_m(half_side, params.light_size) : FloorShadow::reach_m(half_side);
    return floor_shadow_pixels(block, *boxes, reach_m, size);
}

void SceneView::draw_stage(const LookPrograms& programs, bool floor) const
{
    if (floor) stage_.draw_floor(programs.floor);
    stage_.draw_background(programs.background);
}

// The same pixels, of which most are copied where the picture before had them too.
void SceneView::draw_kept_stage(const ViewParams& params, const ViewBlock& block, const Viewport& viewport)
{
    const LookPrograms& programs = *programs_[static_cast<std::size_t>(params.look)];
    const glm::ivec2 size(viewport.width, viewport.height);
    if (!backdrop_.repeats({block, params.look, params.floor != 0, size})) return draw_stage(programs, params.floor);
    if (!backdrop_.is_drawn()) {
        ViewBlock unshadowed = block;
        unshadowed.shadow_centre.w = 0;
        set_view(unshadowed);
        backdrop_.begin();
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_stage(programs, params.floor);
        set_view(block);
    }
    backdrop_.copy_to(viewport.framebuffer);
    const PixelBox box = shadow_pixels(params, block, size);
    if (box.low == box.high) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
    stage_.draw_floor(programs.floor);
    glDisable(GL_SCISSOR_TEST);
}

void SceneView::draw_figures(const ViewParams& params)
{
    const LookPrograms& programs = *programs_[static_cast<std::size_t>(params.look)];
    TextureScale scale{params.texture_scale, {}};
    if (params.look == Look::cloth) scale.thread_spacing = params.thread_spacing;
    // First what mostly hides the other, so that little is shaded twice.
    if (overlay_ && !overlay_->heat.values.empty())
        overlay_renderer_->draw_cloth(overlay_->heat, cloth_);
    else
        cloth_.draw(programs.cloth, scale);
    programs.body.use();
    bodies_.draw_faces();
}

void SceneView::draw_marks(glm::ivec2 size)
{
    if (overlay_) overlay_renderer_->draw_marks(*overlay_, size);
}

// Over what stands around them, which the picture holds already.
void SceneView::draw_smooth_figures(const ViewParams& params, const ViewBlock& block, const Viewport& viewport)
{
    const glm::ivec2 size(viewport.width, viewport.height);
    const auto boxes = overlay_ ? std::nullopt : figure_bounds();  // marks may lie anywhere
    const PixelBox box = boxes ? pixels_of(*boxes, block.view_projection, size) : PixelBox{{0, 0}, size};
    if (box.low == box.high) return;
    layer_.begin(size, params.samples, box);
    const bool floor_hides =
        params.floor && glm::dot(glm::vec3(block.floor_plane), glm::vec3(block.eye)) > block.floor_plane.w;
    if (floor_hides) glEnable(GL_CLIP_DISTANCE0);
    draw_figures(params);
    draw_marks(size);
    glDisable(GL_CLIP_DISTANCE0);
    layer_.lay_over(viewport.framebuffer);
}

void SceneView::set_view(const ViewBlock& block)
{
    if (view_block_.size_bytes() == 0) view_block_ = Buffer(sizeof block, nullptr, GL_STREAM_DRAW);
    view_block_.update(0, std::as_bytes(std::span(&block, 1)));
    view_block_.bind_block(GL_UNIFORM_BUFFER, BLOCK_VIEW);
}

void SceneView::draw(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, const Viewport& viewport)
{
    assert(viewport.width > 0 && viewport.height > 0);
    prepare(params.look);
    if (overlay_ && !overlay_renderer_) overlay_renderer_.emplace();
    const float aspect = float(viewport.width) / float(viewport.height);
    const Camera camera = make_camera(params, aspect);
    const ViewBlock block = make_view_block(params, camera, floor_of(params, bodies.bodies, bodies.time_s));
    set_view(block);
    cloth_.set_positions(positions, normals_of(params.look));
    bodies_.set_bodies(bodies.bodies, bodies.time_s);
    begin_picture(viewport);
    cast_shadows(params, block, aspect);
    begin_picture(viewport);
    // Every pixel is drawn, so only the depth is cleared.
    glClear(GL_DEPTH_BUFFER_BIT);
    if (params.samples == 1) {
        draw_figures(params);
        draw_stage(*programs_[static_cast<std::size_t>(params.look)], params.floor);
        draw_marks({viewport.width, viewport.height});
    } else {
        draw_kept_stage(params, block, viewport);
        draw_smooth_figures(params, block, viewport);
    }
    glBindVertexArray(0);
    barrier_draw_to_compute();
}

void SceneView::draw_picture(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, Picture& picture)
{
    if (!target_ || target_->width() != params.width || target_->height() != params.height)
        target_.emplace(params.width, params.height, 1);
    draw(params, positions, bodies, {target_->id(), params.width, params.height});
    picture.width = params.width;
    picture.height = params.height;
    target_->read_rgba(picture.rgba);
}

}  // namespace nuno
