// The scene that the viewer shows.
#include "app/viewer_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/cloth_view.h"
#include "core/error.h"
#include "core/files.h"
#include "core/stopwatch.h"
#include "model/stability.h"
#include "sim/start_check.h"

namespace nuno {
namespace {

// The view as the scene's file has it. Its settings were checked when the scene was read.
ViewParams read_view(const Scene& scene)
{
    ViewParams view;
    for (const ViewSetting& setting : scene.view)
        if (const ParamInfo* info = find_param(view_param_table(), setting.name))
            set_param_text(*info, &view, setting.text, setting.where);
    return view;
}

std::unique_ptr<SceneView> make_picture(const Simulation& simulation)
{
    return std::unique_ptr<SceneView>(new SceneView(make_scene_view(simulation)));
}

}  // namespace

ViewerSession::ViewerSession(const ViewerOptions& options, ViewerLog& log, bool record)
    : log_(log),
      load_(options.load),
      record_(record),
      quiet_(options.quiet),
      goal_(options.promise),
      trade_(options.promise),
      paused_(options.paused)
{
    show(options.start);
}

void ViewerSession::show(ViewerScene scene)
{
    const ViewParams file_view = read_view(scene.scene);
    auto simulation = std::make_unique<Simulation>(std::move(scene.scene), scene.params);
    picture_ = make_picture(*simulation);
    overlays_ = {};
    simulation_ = std::move(simulation);
    promise_.reset();
    history_.clear();
    view_ = scene.view;
    file_view_ = file_view;
    started();
    log_.action("scene {}", simulation_->scene().name);
    trade_.start(simulation_->scene(), simulation_->asked_params());
    if (trade_.ladder()) {
        log_.action("ladder of {} rungs remembered", trade_.ladder()->rungs.size());
        if (goal_) begin_promise();
    } else if (goal_) {
        measure_ladder();
        trade_.promise_when_measured();
    }
}

void ViewerSession::started()
{
    recorder_ = {};
    if (promise_) promise_->restart();
    if (went_bad_) paused_ = false;
    went_bad_ = false;
    error_.clear();
    stop_recording();
    judge_stability();
    tell_of_start();
    ++start_count_;
    time_.begin(*simulation_);
    log_.set_frame(0);
}

// Once for each change of the parameters: it looks at every spring.
void ViewerSession::judge_stability()
{
    stability_warning_ = simulation_->stability_warning();
    if (stability_warning_) stable_substeps_ = least_stable_substeps(simulation_->model(), simulation_->params());
}

// Of a start that is tangled, on stderr and in the window; a restart that has nothing new says nothing.
void ViewerSession::tell_of_start()
{
    std::vector<std::string> lines = start_remarks(simulation_->start_check(), simulation_->params());
    if (lines == start_remarks_) return;
    start_remarks_ = std::move(lines);
    if (!quiet_)
        for (const std::string& line : start_remarks_) fmt::print(stderr, "{}: {}\n", simulation_->scene().name, line);
    if (simulation_->start_check().tangled.crossing > 0) error_ = fmt::format("{}", fmt::join(start_remarks_, "\n"));
}

void ViewerSession::note_error(const std::exception& error)
{
    error_ = error.what();
    log_.action("error {}", error_);
}

// Runs the simulation; where its numbers go bad, it stays as it is and waits for a restart.
template <class Run>
void ViewerSession::run(Run run)
{
    try {
        run();
    } catch (const Error& error) {
        went_bad_ = error.code() == ExitCode::went_bad;
        set_paused(true);
        note_error(error);
    }
    log_.set_frame(simulation_->frame());
}

// In the window too: another setting changes what the panel shows.
void ViewerSession::keep_promise(const FrameStats& frame)
{
    if (!promise_) return;
    for (const std::string& line : promise_->look(*simulation_, frame)) {
        trade_.forget_frames();
        if (!quiet_) fmt::print(stderr, "{}: {}\n", simulation_->scene().name, line);
        log_.action("promise {}", line);
        judge_stability();
    }
}

// What every frame asks for, before the next one.
void ViewerSession::after_frame(const FrameStats& frame)
{
    if (record_) recorder_.add(frame, simulation_->diagnostics());
    trade_.add_frame(frame);
    keep_promise(frame);
    time_.note_frame(*simulation_);
    record_frame();
}

std::vector<FrameStats> ViewerSession::advance(double elapsed_s)
{
    if (is_at_rest()) return {};
    std::vector<FrameStats> frames;
    run([&] {
        simulation_->advance(elapsed_s / time_.slowness(), [&](const FrameStats& frame) {
            frames.push_back(frame);
            after_frame(frame);
        });
    });
    return frames;
}

std::vector<FrameStats> ViewerSession::step()
{
    if (went_bad_ || trade_.is_measuring()) return {};
    paused_ = true;
    std::vector<FrameStats> frames;
    run([&] {
        frames.push_back(simulation_->advance_frame());
        after_frame(frames.back());
    });
    log_.action("stepped");
    return frames;
}

void ViewerSession::set_paused(bool paused)
{
    if (paused == paused_ || (went_bad_ && !paused)) return;
    paused_ = paused;
    log_.action("{}", paused ? "paused" : "playing");
}

void ViewerSession::restart()
{
    log_.action("restarted");
    simulation_->restart();
    started();
}

void ViewerSession::load(const std::string& name_or_path)
{
    try {
        show(load_(name_or_path));
    } catch (const std::exception& error) {
        note_error(error);
    }
}

void ViewerSession::rebuild_picture()
{
    picture_ = make_picture(*simulation_);
    overlays_ = {};
}

void ViewerSession::use_stable_substeps()
{
    set_sim_param(*find_param(sim_param_table(), "substeps"), stable_substeps_);
    if (went_bad_) restart();
}

void ViewerSession::set_slowness(int slowness)
{
    time_.set_slowness(std::clamp(slowness, 1, SessionTime::kMostSlowness));
    log_.action("speed 1/{}", time_.slowness());
}

void ViewerSession::draw(const Viewport& viewport, StageTimes& stage_ms)
{
    Stopwatch watch;
    GLuint positions = simulation_->position_buffer();
    // Numbers that are none, or huge, are nothing to look at: faces of one point leave the cloth out.
    if (went_bad_)
        positions = picture_->upload_positions(std::vector<glm::vec4>(simulation_->model().vertex_count()));
    else if (positions == 0)
        positions = picture_->upload_positions(simulation_->state().positions);
    stage_ms.upload += watch.elapsed_ms();
    picture_->set_overlay(went_bad_ ? nullptr : overlays_.gather(view_, *simulation_));
    picture_->draw(view_, positions, {simulation_->bodies(), simulation_->time_s()}, viewport);
}

void ViewerSession::write_report(const std::filesystem::path& path, const MachineInfo& machine,
                                 const nlohmann::ordered_json& window)
{
    nlohmann::ordered_json report =
        make_report(recorder_, *simulation_, machine, params_json(view_param_table(), &view_));
    report["window"] = window;
    if (promise_) report["promise"] = promise_->report();
    write_whole(path, report.dump(2) + "\n");
}

}  // namespace nuno
