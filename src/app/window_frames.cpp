// The tally of the window.
#include "app/window_frames.h"

#include <algorithm>

#include "core/quantile.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

Json spread_of(const std::vector<WindowFrameTimes>& times, double WindowFrameTimes::*part)
{
    if (times.empty()) return nullptr;
    std::vector<double> ms;
    for (const WindowFrameTimes& time : times) ms.push_back(time.*part);
    return {{"median", median(ms)}, {"p95", quantile(ms, 0.95)}};
}

}  // namespace

void WindowFrames::add(int simulated, const WindowFrameTimes& times)
{
    if (times_.size() < kTimed)
        times_.push_back(times);
    else
        times_[static_cast<std::size_t>(shown_) % kTimed] = times;
    ++shown_;
    simulated_ += simulated;
    skipped_ += std::max(0, simulated - 1);
}

Json WindowFrames::json() const
{
    return {{"shown", shown_},
            {"simulated", simulated_},
            {"skipped", skipped_},
            {"frame_ms", spread_of(times_, &WindowFrameTimes::frame)},
            {"render_ms", spread_of(times_, &WindowFrameTimes::render)},
            {"panel_ms", spread_of(times_, &WindowFrameTimes::panel)}};
}

}  // namespace nuno
