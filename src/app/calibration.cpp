// The thread that measures.
#include "app/calibration.h"

#include <utility>

#include "app/auto_memory.h"
#include "core/error.h"

namespace nuno {

Calibration::Result Calibration::measured(const std::stop_token& stop, State& state, Scene scene, const SimParams& base,
                                          const AutoGoal& goal)
{
    const SweepProgress progress = [&](std::size_t done, std::size_t total) {
        const std::lock_guard lock(state.mutex);
        state.progress = {done, total};
        return true;
    };
    const FrameWatch watch = [&] {
        if (stop.stop_requested()) throw Error("given up; what was measured is remembered", ExitCode::interrupted);
    };
    try {
        SceneStudy study(std::move(scene), base, watch);
        PointStore store(memory_directory(study), memory_header(study), FormerPoints::keep_own);
        const AutoChoice choice = choose_setting(study, goal, store, progress);
        MeasuredLadder ladder = measure_ladder(study, base, goal, choice, store, progress);
        if (ladder.rungs.empty()) return {{}, "no setting that was tried ran to its end"};
        return {std::move(ladder), ""};
    } catch (const std::exception& error) {
        return {{}, error.what()};
    }
}

void Calibration::start(Scene scene, const SimParams& base, const AutoGoal& goal)
{
    give_up();
    is_running_ = true;
    state_ = std::make_shared<State>();
    thread_ = std::jthread([state = state_, before = std::move(thread_), scene = std::move(scene), base,
                            goal](const std::stop_token& stop) mutable {
        if (before.joinable()) before.join();
        Result result = stop.stop_requested() ? Result{} : measured(stop, *state, std::move(scene), base, goal);
        const std::lock_guard lock(state->mutex);
        state->result = std::move(result);
    });
}

void Calibration::give_up()
{
    thread_.request_stop();
    is_running_ = false;
}

Calibration::Progress Calibration::progress() const
{
    if (!is_running_) return {};
    const std::lock_guard lock(state_->mutex);
    return state_->progress;
}

std::optional<Calibration::Result> Calibration::take()
{
    if (!is_running_) return std::nullopt;
    const std::lock_guard lock(state_->mutex);
    if (state_->result) is_running_ = false;
    return std::exchange(state_->result, std::nullopt);
}

}  // namespace nuno
