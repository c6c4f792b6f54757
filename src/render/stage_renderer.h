// Draws what is around the cloth: the background and the floor.
#pragma once

#include "gl/program.h"
#include "gl/vertex_array.h"

namespace nuno {

class StageRenderer
{
  public:
    // Both draw with a look's program and the uniform block View bound, after all that stands in front of them. The
    // floor is seen from above only, and shows the texture bound to UNIT_FLOOR_SHADOW.
    void draw_floor(const Program& program) const;
    void draw_background(const Program& program) const;

  private:
    VertexArray no_vertices_;
};

}  // namespace nuno
