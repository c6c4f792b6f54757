// Counts and times of the frames that the window showed, from its first to its last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

namespace nuno {

// Of one frame of the window, by the clock [ms].
struct WindowFrameTimes
{
    double frame = 0;   // from its input to its picture on the screen, with all that was simulated for it
    double render = 0;  // the picture
    double panel = 0;   // the panels over it
};

class WindowFrames
{
  public:
    // Times are kept of so many frames, the last ones: a window may be open for days.
    static constexpr std::size_t kTimed = 4096;

    // A frame was shown, after `simulated` frames of the cloth since the one before; all of these but the last were
    // skipped.
    void add(int simulated, const WindowFrameTimes& times);

    std::int64_t shown() const { return shown_; }
    std::int64_t simulated() const { return simulated_; }
    std::int64_t skipped() const { return skipped_; }  // simulated and never shown

    // As in docs/report.md.
    nlohmann::ordered_json json() const;

  private:
    std::int64_t shown_ = 0, simulated_ = 0, skipped_ = 0;
    std::vector<WindowFrameTimes> times_;  // a ring once it is full
};

}  // namespace nuno
