// Measures a ladder of settings beside the window, on a thread of its own.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/auto_ladder.h"

namespace nuno {

// One measurement at a time: the next begins when the one given up has ended, which takes a frame of a run, as two would
// disturb each other's times. All functions are of the thread that owns the object.
class Calibration
{
  public:
    Calibration() = default;
    ~Calibration() = default;  // gives up, and waits for the frame at hand
    Calibration(const Calibration&) = delete;
    Calibration& operator=(const Calibration&) = delete;

    // Gives up what is going on. It needs no OpenGL.
    void start(Scene scene, const SimParams& base, const AutoGoal& goal);
    void give_up();
    // From start() until its result is taken, or it is given up.
    bool is_running() const { return is_running_; }

    // Settings that were tried, and how many there are; the search may end before. 0 of 0 while the runs are made that
    // settings are held against.
    struct Progress
    {
        std::size_t tried = 0, count = 0;
        bool operator==(const Progress&) const = default;
    };
    Progress progress() const;

    struct Result
    {
        std::optional<MeasuredLadder> ladder;  // none where there was an error
        std::string error;
    };
    // Once, when it is done.
    std::optional<Result> take();

  private:
    // What the two threads share.
    struct State
    {
        std::mutex mutex;
        Progress progress;
        std::optional<Result> result;
    };
    static Result measured(const std::stop_token& stop, State& state, Scene scene, const SimParams& base,
                           const AutoGoal& goal);

    std::shared_ptr<State> state_;  // of the thread started last; none: there was none
    bool is_running_ = false;
    std::jthread thread_;
};

}  // namespace nuno
