// One picture of a scene: cloth, bodies, floor and background, in a window or off screen.
#pragma once

#include <optional>
#include <span>

#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "model/body.h"
#include "render/body_renderer.h"
#include "render/cloth_renderer.h"
#include "render/floor_shadow.h"
#include "render/picture.h"
#include "render/stage_renderer.h"
#include "render/view_params.h"

namespace nuno {

// Where a picture goes.
struct Viewport
{
    GLuint framebuffer = 0;  // 0: the window's
    int width = 0, height = 0;
};

// Bodies, and the time whose poses are drawn.
struct BodiesInTime
{
    const Bodies& bodies;
    double time_s = 0;
};

class SceneView
{
  public:
    // Error where a texture cannot be read.
    explicit SceneView(const ClothTopology& cloth) : cloth_(cloth) {}

    // Positions that the CPU holds, as a buffer that the draws below take.
    GLuint upload_positions(std::span<const glm::vec4> positions) { return cloth_.upload_positions(positions); }

    // Draws into `viewport`; `positions` is a buffer of one vec4 a vertex (xyz [m] used), read as all earlier kernels
    // leave it. Sets all the OpenGL state it relies on; `viewport.framebuffer` stays bound.
    void draw(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, const Viewport& viewport);

    // Draws params.width x height pixels off screen and waits for them.
    void draw_picture(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, Picture& picture);

  private:
    ClothRenderer cloth_;
    BodyRenderer bodies_;
    StageRenderer stage_;
    FloorShadow shadow_;
    Buffer view_block_;
    std::optional<Framebuffer> target_;
    int target_samples_ = 0;  // as asked; the device may give fewer
};

}  // namespace nuno
