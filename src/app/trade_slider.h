// The slider from fast to accurate: the ladder that it moves on, remembered or measured beside the window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/auto_ladder.h"
#include "app/calibration.h"
#include "sim/frame_stats.h"

namespace nuno {

class TradeSlider
{
  public:
    // Without a promise it looks for settings around a small error.
    explicit TradeSlider(const std::optional<AutoGoal>& promise);

    // Another scene, with the parameters that it starts with: takes the ladder that is remembered for it, if any. Gives
    // up a measurement.
    void start(const Scene& scene, const SimParams& asked);
    // The same where a parameter has built another cloth.
    void rebuilt(const Scene& scene, const SimParams& asked);

    // Measures with these parameters, where nothing is remembered of them; what auto chooses is as at the start.
    void measure(const Scene& scene, const SimParams& asked);
    void give_up() { calibration_.give_up(); }
    bool is_measuring() const { return calibration_.is_running(); }
    Calibration::Progress progress() const { return calibration_.progress(); }
    // What is being measured is for a promise, which is then to be kept.
    void promise_when_measured() { is_for_promise_ = true; }
    bool is_for_promise() const { return is_for_promise_; }

    enum class News
    {
        none,
        progress,
        done  // a ladder, or error()
    };
    News follow();

    const std::optional<MeasuredLadder>& ladder() const { return ladder_; }
    const std::string& error() const { return error_; }  // why the last measurement has no ladder
    // A parameter by name that the ladder was measured with another value of; empty where all are the same.
    std::string changed_param(const SimParams& asked) const;
    // The rung whose settings these parameters have, whatever the others are.
    std::optional<std::size_t> rung_of(const SimParams& asked) const;

    // Of solver and collision: the median of the last frames since they were forgotten [ms].
    std::optional<double> frame_ms() const;
    void add_frame(const FrameStats& frame);
    void forget_frames() { recent_ms_.clear(); }

  private:
    AutoGoal goal_;
    SimParams start_;  // of the scene and the command line
    std::optional<MeasuredLadder> ladder_;
    bool is_for_promise_ = false;
    std::string error_;
    std::vector<double> recent_ms_;  // the oldest first
    Calibration::Progress shown_;
    Calibration calibration_;
};

}  // namespace nuno
