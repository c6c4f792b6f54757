// The viewer's panel: the scene and its parameters down the left side, what they cost over the picture.
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/panel_params.h"
#include "app/panel_plots.h"
#include "app/stage_graph.h"
#include "app/viewer_log.h"
#include "app/viewer_pace.h"
#include "app/viewer_session.h"
#include "gl/context.h"
#include "model/diagnostics.h"
#include "model/stability.h"

namespace nuno {

// What the viewer has measured, for the panel to show.
struct ViewerMeters
{
    GlInfo gl;
    StageHistory stages;
    ViewerPace pace;
    CollisionCounts count;                      // of the last simulated frame
    std::optional<Diagnostics> diagnostics;     // of some frame lately; none where the user turned them off
    std::optional<PresentStability> stability;  // of the same frame
    bool measure = true;                        // the checkbox: diagnostics copy the cloth from the device
    PlottedValues plots;
};

// What the user asked for that the panel cannot do itself.
struct PanelRequests
{
    bool screenshot = false, frame_all = false, save = false;
};

class Panel
{
  public:
    explicit Panel(ViewerLog& log) : log_(log), params_(log) {}

    bool visible = true, help = false;
    std::string notice;  // one line of good news, such as the name of a file that was written

    // Fits the panel to a window of `size` before a frame; `scale`: window coordinates for each unit of the layout.
    void lay_out(glm::vec2 size, float scale);
    // Width of the side panel, which hides what is under it [window coordinates].
    float covered_width() const { return visible ? width_ : 0; }
    // Whether a panel lay over this place in the last frame.
    bool covers(glm::vec2 place) const;

    PanelRequests draw(ViewerSession& session, ViewerMeters& meters);

  private:
    PanelRequests draw_side(ViewerSession& session);
    void draw_cost(const ViewerSession& session, ViewerMeters& meters);
    void draw_plot_window(const ViewerSession& session, const PlottedValues& values);
    void draw_scene_list(ViewerSession& session);
    PanelRequests draw_buttons(ViewerSession& session);
    void draw_parameters(ViewerSession& session);
    // The height from which on they cover the picture.
    float draw_messages(ViewerSession& session);
    bool message_button(const std::string& text);
    void note_place();

    ViewerLog& log_;
    ParamPanel params_;
    std::vector<std::string> scenes_;  // of the list, read each time it is opened
    glm::vec2 size_{0};                // of the window
    float scale_ = 0, width_ = 0;
    std::vector<glm::vec4> places_;  // left, top, right, bottom of each panel of the last frame
    bool place_again_ = true;        // the window's size or the scale has changed
};

// The contents of the window with the cost.
void draw_cost_panel(const ViewerSession& session, ViewerMeters& meters, ViewerLog& log, float scale);

// The section with the slider from fast to accurate.
void draw_trade_slider(ViewerSession& session, ViewerLog& log);

// The rows with one frame back, undo, redo, save, slow motion and the frames kept. Whether to save.
bool draw_transport(ViewerSession& session, ViewerLog& log);

// The section with a button for each preset.
void draw_presets(ViewerSession& session, ViewerLog& log);

// The section for recording.
void draw_record(ViewerSession& session, ViewerLog& log);

// File names of the saved scenes in the working directory: NAME.toml with NAME.state beside it.
std::vector<std::string> saved_scene_names();

// Begins the window in the middle that lists keys and mouse movements, and fills it; the caller ends it. `open` becomes
// false where it is closed.
void begin_help(bool& open);

}  // namespace nuno
