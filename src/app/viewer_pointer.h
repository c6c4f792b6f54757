// What the mouse does to the picture: drags a vertex of the cloth or a body, or moves the camera.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/viewer_grip.h"
#include "app/viewer_log.h"
#include "app/viewer_session.h"
#include "app/window.h"

namespace nuno {

// The part of the window that the picture fills.
struct PointerArea
{
    glm::vec2 corner, size;  // in window coordinates
    float scale;             // window coordinates for each unit of the layout
    // Whether what is pressed at a place of the window belongs to the panel.
    std::function<bool(glm::vec2)> is_on_panel;
};

class ViewerPointer
{
  public:
    explicit ViewerPointer(ViewerLog& log) : log_(log) {}

    void handle(const std::vector<PointerEvent>& events, const PointerArea& area, ViewerSession& session);
    // Pins the vertex under the pointer where it is, or lets it go.
    void toggle_pin(const PointerArea& area, ViewerSession& session);
    // True while a button that was pressed on the picture is down.
    bool busy() const { return motion_ != Motion::none; }
    // Marks what is dragged, and how far it is from the mouse, on top of the picture.
    void draw_mark(const PointerArea& area, ViewerSession& session) const;

  private:
    enum class Motion
    {
        none,
        drag,
        orbit,
        pan
    };
    void press(const PointerEvent& event, const PointerArea& area, ViewerSession& session);
    void move(glm::vec2 place, const PointerArea& area, ViewerSession& session);
    void drag(const PointerArea& area, ViewerSession& session);
    void release(const PointerEvent& event, ViewerSession& session);
    bool take(const PointerEvent& event, const PointerArea& area, ViewerSession& session);
    void log_camera(const ViewParams& view);

    ViewerLog& log_;
    Motion motion_ = Motion::none;
    int button_ = -1;  // that started the motion
    glm::vec2 last_place_{0};
    std::optional<ViewerGrip> grip_;
    int grip_start_count_ = 0;  // the session's when it was taken
};

}  // namespace nuno
