// Background and floor; their vertices are made in the shaders.
#include "render/stage_renderer.h"

namespace nuno {

StageRenderer::StageRenderer()
    : floor_(draw_program("render/floor.vert", "render/floor.frag")),
      background_(draw_program("render/whole_picture.vert", "render/background.frag"))
{
}

void StageRenderer::draw_floor() const
{
    floor_.use();
    no_vertices_.bind();
    glEnable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_CULL_FACE);
}

void StageRenderer::draw_background() const
{
    background_.use();
    no_vertices_.bind();
    // It lies at the greatest depth there is.
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
}

}  // namespace nuno
