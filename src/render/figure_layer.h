// What moves is drawn with several samples a pixel into a layer of its own, over only so much of the picture as it can
// cover, and laid over what stands around it, which needs no more than one.
#pragma once

#include <optional>

#include "gl/program.h"
#include "gl/sample_target.h"
#include "gl/vertex_array.h"
#include "render/pixel_box.h"

namespace nuno {

class FigureLayer
{
  public:
    FigureLayer();

    // Draws go into the layer from now on, and only within `box`; it is empty there. `size`: of the picture in pixels.
    void begin(glm::ivec2 size, int samples, const PixelBox& box);

    // Lays the mean of the samples over `framebuffer`, which stays bound, within the box.
    void lay_over(GLuint framebuffer) const;

  private:
    Program program_;
    VertexArray no_vertices_;
    std::optional<SampleTarget> target_;
    int asked_samples_ = 0;  // the device may give fewer
};

}  // namespace nuno
