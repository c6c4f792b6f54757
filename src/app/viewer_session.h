// The scene that the viewer shows: runs or rests, takes changes, and keeps what went wrong as a message instead of
// ending.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/overlays.h"
#include "app/param_history.h"
#include "app/presets.h"
#include "app/session_time.h"
#include "app/trade_slider.h"
#include "app/viewer.h"
#include "app/viewer_log.h"
#include "app/viewer_recording.h"
#include "render/scene_view.h"
#include "sim/run_recorder.h"
#include "sim/simulation.h"

namespace nuno {

class ViewerSession
{
  public:
    // An OpenGL context must be current, and stay so. `record`: every frame is kept for a report.
    // Error where the scene does not work.
    ViewerSession(const ViewerOptions& options, ViewerLog& log, bool record);

    Simulation& simulation() { return *simulation_; }
    const Simulation& simulation() const { return *simulation_; }
    ViewParams& view() { return view_; }
    // What the scene's file says, for going back to.
    const SimParams& file_params() const { return simulation_->scene().params; }
    const ViewParams& file_view() const { return file_view_; }
    // Draws the present positions with the parameters of view(); adds the time of an upload to `stage_ms`.
    void draw(const Viewport& viewport, StageTimes& stage_ms);

    // Of what the last draw showed over the picture.
    const OverlayLegend& legend() const { return overlays_.legend(); }

    bool paused() const { return paused_; }
    bool is_at_rest() const { return paused_ || trade_.is_measuring(); }
    bool went_bad() const { return went_bad_; }  // only a restart or an earlier frame helps
    // What was refused last, or how the simulation went bad; empty where all is well.
    const std::string& error() const { return error_; }
    void note_error(const std::exception& error);
    void dismiss_error() { error_.clear(); }
    const std::optional<std::string>& stability_warning() const { return stability_warning_; }
    int stable_substeps() const { return stable_substeps_; }  // that end the warning; 0 where no number does
    // Grows with every start from the beginning; vertices may have other numbers after it.
    int start_count() const { return start_count_; }

    // The simulated frames that `elapsed_s` of wall time ask for; none while paused, or while settings are measured:
    // frames beside it would disturb the times, which are remembered.
    std::vector<FrameStats> advance(double elapsed_s);
    std::vector<FrameStats> step();  // one frame, and pauses; none while settings are measured
    void set_paused(bool paused);
    void restart();
    // Shows another scene; where it cannot be read or does not work, the present one goes on and error() says why.
    void load(const std::string& name_or_path);
    void set_sim_param(const ParamInfo& info, double value);
    // Sets the number of substeps that is stable, and starts again where the simulation went bad.
    void use_stable_substeps();
    void set_view_param(const ParamInfo& info, double value);
    void use_preset(const Preset& preset);

    // Changes of parameters, of presets and of the slider; the camera moved by the mouse is none of them.
    const ParamHistory& history() const { return history_; }
    void undo();
    void redo();
    void end_drag() { history_.end_drag(); }
    // Writes the cloth as it is as NAME_0001.toml or the next free name, with its .state, into the working directory.
    std::filesystem::path save();

    // Pins a vertex where it is, or lets it go, until the next restart.
    void toggle_pin(std::uint32_t vertex);

    // Records every frame from the present one on, or ends that; so does a restart, another scene, and going back.
    RecordingPlan& recording_plan() { return recording_plan_; }
    const ViewerRecording& recording() const { return recording_; }
    void toggle_recording();
    void stop_recording();
    // What the last recording wrote, once; empty where there is nothing new.
    std::string take_recorded() { return std::exchange(recorded_, {}); }

    const SessionTime& time() const { return time_; }
    void set_slowness(int slowness);  // brought into its range
    void keep_frames(bool keep) { time_.keep_frames(keep, *simulation_); }
    // Pauses at the kept frame nearest to this one; nothing where none is kept.
    void show_frame(int frame);

    // The slider from fast to accurate.
    const TradeSlider& trade() const { return trade_; }
    const PromiseKeeper* promise() const { return promise_.get(); }
    // On which the parameters are; none where they were set by hand.
    std::optional<std::size_t> rung() const;
    // Measures the ladder of the slider, where it is not remembered.
    void measure_ladder();
    void give_up_measuring();
    // Ends a promise.
    void use_rung(std::size_t rung);
    // Takes what was measured, and begins to keep what was promised. Whether there is something new to show.
    bool follow_measuring();

    // Writes the report of the frames since the last start, with what the window showed.
    void write_report(const std::filesystem::path& path, const MachineInfo& machine,
                      const nlohmann::ordered_json& window);

  private:
    void show(ViewerScene scene);
    void started();
    void judge_stability();
    void tell_of_start();
    template <class Run>
    void run(Run run);
    void keep_promise(const FrameStats& frame);
    void record_frame();
    void after_frame(const FrameStats& frame);
    void begin_promise();
    bool set_rung(std::size_t rung);
    void rebuild_picture();
    bool change_sim_params(const SimParams& params, const std::string& told);
    bool set_values(const std::vector<ParamHistory::Value>& values, const std::string& told);

    ViewerLog& log_;
    SceneLoader load_;
    bool record_, quiet_;
    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<SceneView> picture_;
    Overlays overlays_;
    std::optional<AutoGoal> goal_;  // that was promised
    std::unique_ptr<PromiseKeeper> promise_;
    TradeSlider trade_;
    ViewParams view_, file_view_;
    ParamHistory history_;
    SessionTime time_;
    RecordingPlan recording_plan_;
    ViewerRecording recording_;
    std::string recorded_;
    RunRecorder recorder_;
    bool paused_, went_bad_ = false;
    std::string error_;
    std::optional<std::string> stability_warning_;
    int stable_substeps_ = 0;
    std::vector<std::string> start_remarks_;  // told last
    int start_count_ = 0;
};

}  // namespace nuno
