// The loop of the viewer: input, simulation, picture, panel.
#include "app/viewer.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "app/interrupt.h"
#include "app/machine.h"
#include "app/overlay_keys.h"
#include "app/panel.h"
#include "app/viewer_log.h"
#include "app/viewer_picture.h"
#include "app/viewer_pointer.h"
#include "app/viewer_ui.h"
#include "app/window.h"
#include "app/window_frames.h"
#include "core/error.h"
#include "core/stopwatch.h"

namespace nuno {
namespace {

constexpr int kFramesPerMeasurement = 10;
constexpr double kLivelyMs = 1000;       // after an input the panel may still change,
constexpr int kLivelyFrames = 3;         // however slow the frames are
constexpr double kNoticeMs = 8000;       // a notice stays
constexpr double kPlayingWaitS = 0.001;  // while the next simulated frame is not due yet
constexpr double kPausedWaitS = 0.25;
constexpr double kMinimisedWaitS = 0.1;

// Where asserts are on, so are the driver's own checks.
#ifdef NDEBUG
constexpr bool kAsserts = false;
#else
constexpr bool kAsserts = true;
#endif

class Viewer
{
  public:
    explicit Viewer(const ViewerOptions& options);
    int run();

  private:
    bool frame(const WindowInput& input);
    void handle_keys(const std::vector<KeyEvent>& keys);
    void handle_command(const KeyEvent& event);
    void handle_key(int key);
    void frame_all();
    void stir();
    void add_stats(const std::vector<FrameStats>& stats);
    void measure();
    void show(const WindowInput& input);
    PointerArea picture_area() const;
    void draw_panel(const PointerArea& area);
    void take_photo();
    void save();
    void tell_written(const std::string& name);
    void note_start();
    void finish_recording();
    void end_shown_frame();

    ViewerOptions options_;
    ViewerLog log_;
    Window window_;
    ViewerUi ui_;
    ViewerSession session_;
    ViewerPicture picture_;
    ViewerPointer pointer_;
    Panel panel_;
    ViewerMeters meters_;
    WindowFrames frames_;

    Stopwatch since_advance_, since_begin_, since_shown_, since_input_, since_notice_;
    StageTimes stage_ms_;  // since the last frame that was shown
    int simulated_frames_ = 0;
    double simulated_s_ = 0;
    int frames_to_measurement_ = 0, measured_frame_ = -1;
    int lively_frames_ = kLivelyFrames;
    int start_count_ = 0;
    bool photo_asked_ = false, panel_has_keys_ = false, help_shown_ = false;
    glm::ivec2 pixels_{0};
};

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      log_(options.log_actions),
      window_({"nuno", {options.width, options.height}, options.vsync, options.debug_context || kAsserts}),
      ui_(window_),
      session_(options, log_, !options.json.empty()),
      pointer_(log_),
      panel_(log_)
{
    meters_.gl = gl_info();
    if (const auto remark = software_remark(session_.simulation(), meters_.gl)) {
        if (!options.quiet) fmt::print(stderr, "{}\n", *remark);
        panel_.notice = *remark;
    }
    log_.action("window {}x{} content scale {}", window_.size().x, window_.size().y, window_.content_scale());
}

int Viewer::run()
{
    watch_interrupts();
    bool shown = true;
    while (!window_.should_close() && !interrupted()) {
        const bool minimised = pixels_.x == 0 || pixels_.y == 0;
        const double rest_s = minimised ? kMinimisedWaitS : session_.is_at_rest() ? kPausedWaitS : kPlayingWaitS;
        shown = frame(window_.poll(shown ? 0 : rest_s));
    }
    finish_recording();
    if (!options_.json.empty())
        session_.write_report(options_.json, machine_info(&meters_.gl, session_.simulation().thread_count()),
                              frames_.json());
    if (options_.hash) fmt::print("state-hash {}\n", hash_text(session_.simulation().state()));
    log_.action("shown {} frames; of {} simulated ones {} were skipped", frames_.shown(), frames_.simulated(),
                frames_.skipped());
    log_.action("closed");
    return static_cast<int>(interrupted() ? ExitCode::interrupted : ExitCode::done);
}

// Nobody sees the message in the window any more.
void Viewer::finish_recording()
{
    if (!session_.recording().is_on()) return;
    session_.stop_recording();
    if (!session_.error().empty()) fmt::print(stderr, "nuno: {}\n", session_.error());
}

// True where something was drawn; a window in which nothing changes is left alone.
bool Viewer::frame(const WindowInput& input)
{
    if (input.any) stir();
    if (!input.dropped_files.empty()) session_.load(input.dropped_files.front());
    const glm::ivec2 pixels = window_.framebuffer_size();
    if (pixels != pixels_) log_.action("framebuffer {}x{}", pixels.x, pixels.y);
    if (std::exchange(pixels_, pixels) != pixels) stir();
    const double elapsed_s = since_advance_.lap_ms() / 1000;
    since_begin_ = {};
    if (pixels.x == 0 || pixels.y == 0) return false;
    // Few frames are drawn while settings are measured: on a machine without a graphics card they take a core.
    if (session_.follow_measuring()) lively_frames_ = std::max(lively_frames_, 1);
    const bool was_paused = session_.paused();
    const std::vector<FrameStats> stats = session_.advance(elapsed_s);
    add_stats(stats);
    if (session_.paused() != was_paused) stir();
    const bool lively = lively_frames_ > 0 || since_input_.elapsed_ms() < kLivelyMs || ui_.wants_keys();
    if (stats.empty() && !lively) return false;
    show(input);
    return true;
}

// Something happened that the next frames have to show.
void Viewer::stir()
{
    since_input_ = {};
    lively_frames_ = kLivelyFrames;
}

void Viewer::add_stats(const std::vector<FrameStats>& stats)
{
    for (const FrameStats& frame : stats) {
        for (const StageInfo& stage : kStages) stage_ms_.*stage.ms += frame.stage_ms.*stage.ms;
        simulated_s_ += 1.0 / session_.simulation().params().frame_rate;
        meters_.count = frame.count;
        meters_.plots.add(frame.time_s, frame.count);
    }
    simulated_frames_ += static_cast<int>(stats.size());
    frames_to_measurement_ -= static_cast<int>(stats.size());
}

void Viewer::measure()
{
    if (!meters_.measure || session_.went_bad()) return meters_.diagnostics.reset();
    const int frame = session_.simulation().frame();
    const bool was_shown = session_.paused() && frame != measured_frame_;  // looked back at, or stepped to
    if (meters_.diagnostics && frames_to_measurement_ > 0 && !was_shown) return;
    measured_frame_ = frame;
    meters_.diagnostics = session_.simulation().diagnostics();
    meters_.stability = session_.simulation().stability();
    meters_.plots.add(session_.simulation().time_s(), *meters_.diagnostics);
    frames_to_measurement_ = kFramesPerMeasurement;
}

void Viewer::show(const WindowInput& input)
{
    Stopwatch watch;
    ui_.begin_frame(input.keys);
    panel_.lay_out(glm::vec2(window_.size()), ui_.scale());
    if (std::exchange(help_shown_, panel_.help) != panel_.help)
        log_.action("help {}", panel_.help ? "shown" : "hidden");
    if (std::exchange(panel_has_keys_, ui_.wants_keys()) != ui_.wants_keys())
        log_.action("keys go to the {}", panel_has_keys_ ? "panel" : "picture");
    const PointerArea area = picture_area();
    pointer_.handle(input.pointer, area, session_);
    if (!panel_has_keys_) handle_keys(input.keys);
    if (session_.start_count() != start_count_) note_start();
    double panel_ms = watch.lap_ms();

    const glm::vec2 pixels_per_unit = glm::vec2(pixels_) / glm::vec2(window_.size());
    picture_.draw(session_, pixels_, static_cast<int>(std::lround(area.corner.x * pixels_per_unit.x)), stage_ms_);
    measure();
    watch.lap_ms();
    draw_panel(area);
    panel_ms += watch.lap_ms();
    if (std::exchange(photo_asked_, false)) take_photo();
    window_.swap();

    meters_.stages.add(stage_column(stage_ms_, stage_ms_.render, panel_ms), simulated_frames_);
    frames_.add(simulated_frames_, {since_begin_.elapsed_ms(), stage_ms_.render, panel_ms});
    end_shown_frame();
}

// The window without the side panel.
PointerArea Viewer::picture_area() const
{
    const glm::vec2 corner(std::round(panel_.covered_width()), 0);
    return {corner, glm::max(glm::vec2(window_.size()) - corner, 1.0f), ui_.scale(),
            [this](glm::vec2 place) { return ui_.wants_keys() || panel_.covers(place); }};
}

void Viewer::draw_panel(const PointerArea& area)
{
    if (since_notice_.elapsed_ms() > kNoticeMs) panel_.notice.clear();
    if (std::string recorded = session_.take_recorded(); !recorded.empty()) {
        panel_.notice = std::move(recorded);
        since_notice_ = {};
    }
    const PanelRequests requests = panel_.draw(session_, meters_);
    pointer_.draw_mark(area, session_);
    log_.end_controls();
    ui_.draw();
    glFinish();
    if (requests.save) save();
    photo_asked_ = photo_asked_ || requests.screenshot;
}

void Viewer::end_shown_frame()
{
    meters_.pace.add(since_shown_.lap_ms() / 1000, simulated_s_);
    stage_ms_ = {};
    simulated_s_ = 0;
    simulated_frames_ = 0;
    --lively_frames_;
    if (!options_.debug_context && !kAsserts && !options_.log_actions) return;
    for (const std::string& error : take_gl_errors()) fmt::print(stderr, "view: OpenGL: {}\n", error);
}

// The scene was started: by the user, or because a change built another cloth.
void Viewer::note_start()
{
    start_count_ = session_.start_count();
    window_.set_title("nuno - " + session_.simulation().scene().name);
    meters_.diagnostics.reset();
    meters_.count = {};
    meters_.plots = {};
}

void Viewer::handle_keys(const std::vector<KeyEvent>& keys)
{
    for (const KeyEvent& event : keys) {
        if (event.modified) {
            if (event.control) handle_command(event);
            continue;
        }
        const bool step = event.printed == GLFW_KEY_N || event.printed == GLFW_KEY_RIGHT;
        if (step)
            add_stats(session_.step());
        else if (event.printed == GLFW_KEY_LEFT)
            session_.show_frame(session_.simulation().frame() - 1);
        else if (!event.repeated)
            handle_key(event.printed);
    }
}

void Viewer::handle_command(const KeyEvent& event)
{
    switch (event.printed) {
    case GLFW_KEY_S:
        if (!event.repeated) save();
        break;
    case GLFW_KEY_Z: event.shift ? session_.redo() : session_.undo(); break;
    case GLFW_KEY_Y: session_.redo(); break;
    default: break;
    }
}

void Viewer::handle_key(int key)
{
    switch (key) {
    case GLFW_KEY_SPACE: session_.set_paused(!session_.paused()); break;
    case GLFW_KEY_R: session_.restart(); break;
    case GLFW_KEY_V: session_.toggle_recording(); break;
    case GLFW_KEY_P: pointer_.toggle_pin(picture_area(), session_); break;
    case GLFW_KEY_COMMA: session_.set_slowness(2 * session_.time().slowness()); break;
    case GLFW_KEY_PERIOD: session_.set_slowness(session_.time().slowness() / 2); break;
    case GLFW_KEY_F: frame_all(); break;
    case GLFW_KEY_S:
    case GLFW_KEY_F12: photo_asked_ = true; break;
    case GLFW_KEY_H:
    case GLFW_KEY_F1: panel_.help = !panel_.help; break;
    case GLFW_KEY_TAB: panel_.visible = !panel_.visible; break;
    case GLFW_KEY_ESCAPE:
        if (!std::exchange(panel_.help, false)) window_.close();
        break;
    case GLFW_KEY_Q: window_.close(); break;
    default: press_overlay_key(key, session_); break;
    }
}

void Viewer::frame_all()
{
    if (session_.went_bad()) return;
    const Diagnostics cloth = session_.simulation().diagnostics();
    const glm::vec2 size = picture_area().size;
    frame_box(session_.view(), glm::vec3(cloth.lowest), glm::vec3(cloth.highest), size.x / size.y);
    log_.action("framed all");
}

void Viewer::take_photo()
{
    try {
        const std::string name = write_photo(read_window(pixels_)).string();
        tell_written(name);
    } catch (const std::exception& error) {
        session_.note_error(error);
    }
}

void Viewer::save()
{
    try {
        tell_written(session_.save().string());
    } catch (const std::exception& error) {
        session_.note_error(error);
    }
}

void Viewer::tell_written(const std::string& name)
{
    panel_.notice = "wrote " + name;
    since_notice_ = {};
    log_.action("wrote {}", name);
}

}  // namespace

int run_viewer(const ViewerOptions& options)
{
    Viewer viewer(options);
    return viewer.run();
}

}  // namespace nuno
