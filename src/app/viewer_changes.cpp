// What the session of the viewer does for changes of parameters: making them, taking them back, saving them.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/viewer_session.h"
#include "core/error.h"
#include "sim/saved_scene.h"

namespace nuno {
namespace {

bool is_of(ParamTable table, const ParamInfo* info)
{
    return info >= table.data() && info < table.data() + table.size();
}

}  // namespace

// All of them or, with an error told, none.
bool ViewerSession::change_sim_params(const SimParams& params, const std::string& told)
{
    const SimParams asked = simulation_->asked_params();
    try {
        // A rebuild begins at frame 0, but frame 0 alone tells nothing: this object does.
        const ClothModel* before = &simulation_->model();
        simulation_->set_params(params);
        give_up_measuring();
        for (const ParamChange& change : changes_between(sim_param_table(), &asked, &params))
            if (is_chosen_by_auto(change.info->name) || needs_restart(change.info->name)) promise_.reset();
        if (params.frame_rate != asked.frame_rate) stop_recording();  // its video has the rate of its start
        log_.action("{}", told);
        if (!went_bad_) error_.clear();
        if (&simulation_->model() != before) {
            rebuild_picture();
            started();
            trade_.rebuilt(simulation_->scene(), simulation_->asked_params());
        }
        trade_.forget_frames();
        judge_stability();
        tell_of_start();
        return true;
    } catch (const std::exception& error) {
        note_error(error);
        return false;
    }
}

void ViewerSession::set_sim_param(const ParamInfo& info, double value)
{
    const SimParams before = simulation_->asked_params();
    SimParams params = before;
    try {
        set_param(info, &params, value, "panel");
    } catch (const std::exception& error) {
        return note_error(error);
    }
    if (change_sim_params(params, fmt::format("{} = {}", info.name, param_text(info, value))))
        history_.record(std::string(info.name), changes_between(sim_param_table(), &before, &params), true);
}

void ViewerSession::set_view_param(const ParamInfo& info, double value)
{
    const ViewParams before = view_;
    set_param(info, &view_, value, "panel");
    log_.action("{} = {}", info.name, param_text(info, value));
    history_.record(std::string(info.name), changes_between(view_param_table(), &before, &view_), true);
}

void ViewerSession::use_preset(const Preset& preset)
{
    const SimParams before = simulation_->asked_params(), params = with_preset(preset, before);
    if (change_sim_params(params, fmt::format("preset {}", preset.name)))
        history_.record(std::string(preset.name), changes_between(sim_param_table(), &before, &params));
}

bool ViewerSession::set_values(const std::vector<ParamHistory::Value>& values, const std::string& told)
{
    SimParams params = simulation_->asked_params();
    ViewParams view = view_;
    for (const ParamHistory::Value& value : values) {
        // What follows from a value is among the values.
        ParamInfo info = *value.info;
        info.on_set = nullptr;
        void* block = is_of(sim_param_table(), value.info) ? static_cast<void*>(&params) : &view;
        set_param(info, block, value.value, "panel");
    }
    const SimParams before = simulation_->asked_params();
    if (same_params(before, params))
        log_.action("{}", told);
    else if (!change_sim_params(params, told))
        return false;
    view_ = view;
    return true;
}

void ViewerSession::undo()
{
    if (!history_.can_undo()) return;
    const std::string told = "undone " + history_.undo_name();
    if (!set_values(history_.undo(), told)) history_.redo();
}

void ViewerSession::redo()
{
    if (!history_.can_redo()) return;
    const std::string told = "redone " + history_.redo_name();
    if (!set_values(history_.redo(), told)) history_.undo();
}

void ViewerSession::toggle_pin(std::uint32_t vertex)
{
    try {
        give_up_measuring();
        simulation_->set_pinned(vertex, !simulation_->is_pinned(vertex));
        time_.note_frame(*simulation_);  // in place of the one with the pins before
        log_.action("{} vertex {}", simulation_->is_pinned(vertex) ? "pinned" : "let go of", vertex);
        if (!went_bad_) error_.clear();
        judge_stability();
    } catch (const std::exception& error) {
        note_error(error);
    }
}

std::filesystem::path ViewerSession::save()
{
    const std::string& name = simulation_->scene().name;
    if (went_bad_) throw Error(name + ": its numbers are no longer finite; restart before saving");
    for (int number = 1; number < 10000; ++number) {
        std::filesystem::path path = fmt::format("{}_{:04}.toml", name, number);
        std::filesystem::path state = path;
        std::error_code status;
        if (exists(path, status) || exists(state.replace_extension(".state"), status)) continue;
        save_scene(path, *simulation_, view_settings(view_));
        return path;
    }
    throw Error(fmt::format("save: {0}_0001.toml to {0}_9999.toml are all there already; move some away", name));
}

void ViewerSession::show_frame(int frame)
{
    if (trade_.is_measuring() || time_.frames().empty()) return;
    stop_recording();
    set_paused(true);
    try {
        time_.show(*simulation_, frame);
    } catch (const std::exception& error) {
        return note_error(error);
    }
    if (promise_) promise_->restart();
    if (std::exchange(went_bad_, false)) error_.clear();
    log_.set_frame(simulation_->frame());
    log_.action("shown");
}

}  // namespace nuno
