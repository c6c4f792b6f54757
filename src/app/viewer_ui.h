// Dear ImGui in the viewer's window: set up, styled, and sized to the screen's content scale.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "app/window.h"

namespace nuno {

// Of all panels. The side panel has none of its own: the window is cleared to it there, which costs less than drawing.
inline constexpr glm::vec4 kPanelColour(0.105f, 0.115f, 0.135f, 1);

class ViewerUi
{
  public:
    // `window` must outlive it; its callbacks must be set before, because these call them on.
    explicit ViewerUi(Window& window);
    ~ViewerUi();
    ViewerUi(const ViewerUi&) = delete;
    ViewerUi& operator=(const ViewerUi&) = delete;

    // Starts a frame of the panel with the keys that went down since the last: from here on wants_keys() answers for
    // it.
    void begin_frame(std::span<const KeyEvent> keys);
    // Draws what was described since into the window's framebuffer.
    void draw();

    // Window coordinates for each unit of a layout meant for content scale 1.
    float scale() const { return scale_; }
    // A text is being typed, or a list is open.
    bool wants_keys() const;

  private:
    void press_keys(std::span<const KeyEvent> keys);
    void apply_scale(float content_scale, float pixels_per_unit);

    Window& window_;
    std::vector<int> short_presses_;  // keys that were up again before the frame in which they count as down
    float content_scale_ = 0, pixels_per_unit_ = 0, scale_ = 1;
};

}  // namespace nuno
