// A layer of samples.
#include "render/figure_layer.h"

#include "shaders/shared/render_bindings.h"

namespace nuno {

FigureLayer::FigureLayer() : program_(draw_program("render/whole_picture.vert", "render/layer.frag")) {}

void FigureLayer::begin(glm::ivec2 size, int samples, const PixelBox& box)
{
    if (!target_ || target_->width() != size.x || target_->height() != size.y || asked_samples_ != samples) {
        target_.emplace(size.x, size.y, samples);
        asked_samples_ = samples;
        program_.set(LOCATION_SAMPLE_COUNT, target_->samples());
    }
    target_->begin();
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FigureLayer::lay_over(GLuint framebuffer) const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    // A sample that nothing covers has neither colour nor opacity, so the mean is that of the covered part.
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    target_->bind(UNIT_LAYER);
    program_.use();
    no_vertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace nuno
