// The order of one picture: normals, shadow, then front to back, so that little is shaded twice.
#include "render/scene_view.h"

#include <cassert>

#include "gl/barriers.h"
#include "render/view_block.h"
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

}  // namespace

void SceneView::draw(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, const Viewport& viewport)
{
    assert(viewport.width > 0 && viewport.height > 0);
    const Camera camera = make_camera(params, float(viewport.width) / float(viewport.height));
    const ViewBlock block = make_view_block(params, camera, floor_of(params, bodies.bodies, bodies.time_s));
    if (view_block_.size_bytes() == 0) view_block_ = Buffer(sizeof block, nullptr, GL_STREAM_DRAW);
    view_block_.update(0, std::as_bytes(std::span(&block, 1)));
    view_block_.bind_block(GL_UNIFORM_BUFFER, BLOCK_VIEW);
    cloth_.set_positions(positions);
    bodies_.set_bodies(bodies.bodies, bodies.time_s);
    begin_picture(viewport);
    const bool shadow = params.floor && block.shadow_centre.w > 0;
    if (shadow) {
        shadow_.update(cloth_, bodies_);
        begin_picture(viewport);
    }
    shadow_.bind(UNIT_FLOOR_SHADOW);
    // Every pixel is drawn, so only the depth is cleared.
    glClear(GL_DEPTH_BUFFER_BIT);
    bodies_.draw();
    cloth_.draw(params.look, params.texture_scale);
    if (params.floor) stage_.draw_floor();
    stage_.draw_background();
    glBindVertexArray(0);
    barrier_draw_to_compute();
}

void SceneView::draw_picture(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, Picture& picture)
{
    if (!target_ || target_->width() != params.width || target_->height() != params.height ||
        target_samples_ != params.samples)
    {
        target_.emplace(params.width, params.height, params.samples);
        target_samples_ = params.samples;
    }
    draw(params, positions, bodies, {target_->id(), params.width, params.height});
    target_->resolve();
    picture.width = params.width;
    picture.height = params.height;
    target_->read_rgba(picture.rgba);
}

}  // namespace nuno
