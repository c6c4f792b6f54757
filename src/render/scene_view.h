// One picture of a scene: cloth, bodies, floor and background, in a window or off screen.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "model/body.h"
#include "render/backdrop.h"
#include "render/body_renderer.h"
#include "render/cloth_renderer.h"
#include "render/fabric_light.h"
#include "render/figure_layer.h"
#include "render/floor_shadow.h"
#include "render/look_programs.h"
#include "render/overlay_renderer.h"
#include "render/picture.h"
#include "render/stage_renderer.h"
#include "render/view_block.h"
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

    // Draws into `viewport`, one sample a pixel, but cloth and bodies smoothed by params.samples; `positions` is a buffer
    // of one vec4 a vertex (xyz [m] used), read as all earlier kernels leave it. Sets all the OpenGL state it relies
    // on; `viewport.framebuffer` stays bound. While the camera rests, only what moves and its shadow are drawn anew.
    void draw(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, const Viewport& viewport);

    // Draws params.width x height pixels off screen and waits for them.
    void draw_picture(const ViewParams& params, GLuint positions, const BodiesInTime& bodies, Picture& picture);

    // What the draws from now on lay over the picture, until this is called again; nullptr, as at first: nothing. It
    // must stay until then.
    void set_overlay(const Overlay* overlay) { overlay_ = overlay; }

    // Makes what a look draws with, unless it is there: else its first picture does.
    void prepare(Look look);

  private:
    void cast_shadows(const ViewParams& params, const ViewBlock& block, float aspect);
    void draw_stage(const LookPrograms& programs, bool floor) const;
    void draw_kept_stage(const ViewParams& params, const ViewBlock& block, const Viewport& viewport);
    PixelBox shadow_pixels(const ViewParams& params, const ViewBlock& block, glm::ivec2 size) const;
    void set_view(const ViewBlock& block);
    void draw_figures(const ViewParams& params);
    void draw_marks(glm::ivec2 size);
    void draw_smooth_figures(const ViewParams& params, const ViewBlock& block, const Viewport& viewport);
    std::optional<std::vector<Bounds>> figure_bounds() const;

    ClothRenderer cloth_;
    BodyRenderer bodies_;
    StageRenderer stage_;
    Backdrop backdrop_;
    FigureLayer layer_;
    std::array<std::optional<LookPrograms>, 3> programs_;  // by look
    std::optional<FloorShadow> floor_shadow_;              // of the looks without a light of their own
    std::optional<FabricLight> fabric_light_;              // of the look `cloth`
    const Overlay* overlay_ = nullptr;
    std::optional<OverlayRenderer> overlay_renderer_;  // made with the first overlay
    Buffer view_block_;
    std::optional<Framebuffer> target_;
};

}  // namespace nuno
