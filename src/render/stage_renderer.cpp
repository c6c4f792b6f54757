// Background and floor; their vertices are made in the shaders.
#include "render/stage_renderer.h"

namespace nuno {

void StageRenderer::draw_floor(const Program& program) const
{
    program.use();
    no_vertices_.bind();
    glEnable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_CULL_FACE);
}

void StageRenderer::draw_background(const Program& program) const
{
    program.use();
    no_vertices_.bind();
    // It lies at the greatest depth there is, which needs no writing.
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

}  // namespace nuno
