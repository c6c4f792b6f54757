// The ladder behind the slider.
#include "app/trade_slider.h"

#include <algorithm>
#include <utility>

#include "core/quantile.h"

namespace nuno {
namespace {

// The ladder has a rung for this error and goes on to a fifth of it: the exact end of what is worth its time to look at.
constexpr double kSmallErrorPercent = 0.5;
constexpr std::size_t kRecentFrames = 15;

bool is_same(const ParamInfo& info, const SimParams& a, const SimParams& b)
{
    return param_value(info, &a) == param_value(info, &b);
}

}  // namespace

TradeSlider::TradeSlider(const std::optional<AutoGoal>& promise)
    : goal_(promise ? *promise : auto_goal(kSmallErrorPercent, std::nullopt))
{
}

void TradeSlider::start(const Scene& scene, const SimParams& asked)
{
    start_ = asked;
    rebuilt(scene, asked);
}

void TradeSlider::rebuilt(const Scene& scene, const SimParams& asked)
{
    give_up();
    error_.clear();
    is_for_promise_ = false;
    forget_frames();
    ladder_ = remembered_ladder(scene, on_rung(asked, start_, {}), goal_);
}

void TradeSlider::measure(const Scene& scene, const SimParams& asked)
{
    const SimParams base = on_rung(asked, start_, {});
    error_.clear();
    is_for_promise_ = false;
    ladder_ = remembered_ladder(scene, base, goal_);
    if (!ladder_) calibration_.start(scene, base, goal_);
}

TradeSlider::News TradeSlider::follow()
{
    if (auto result = calibration_.take()) {
        error_ = std::move(result->error);
        ladder_ = std::move(result->ladder);
        return News::done;
    }
    const Calibration::Progress now = calibration_.progress();
    return std::exchange(shown_, now) == now ? News::none : News::progress;
}

std::string TradeSlider::changed_param(const SimParams& asked) const
{
    for (const ParamInfo& info : sim_param_table())
        if (ladder_ && !is_chosen_by_auto(info.name) && !is_same(info, asked, ladder_->base))
            return std::string(info.name);
    return "";
}

std::optional<std::size_t> TradeSlider::rung_of(const SimParams& asked) const
{
    for (std::size_t i = 0; ladder_ && i < ladder_->rungs.size(); ++i) {
        const SimParams params = on_rung(asked, ladder_->base, ladder_->rungs[i].set);
        const ParamTable table = sim_param_table();
        if (std::all_of(table.begin(), table.end(),
                        [&](const ParamInfo& info) { return is_same(info, asked, params); }))
            return i;
    }
    return std::nullopt;
}

std::optional<double> TradeSlider::frame_ms() const
{
    if (recent_ms_.size() < kRecentFrames) return std::nullopt;
    return median(recent_ms_);
}

void TradeSlider::add_frame(const FrameStats& frame)
{
    if (frame.substeps == 0) return;  // cloth asleep costs nothing
    recent_ms_.push_back(simulation_ms(frame.stage_ms));
    if (recent_ms_.size() > kRecentFrames) recent_ms_.erase(recent_ms_.begin());
}

}  // namespace nuno
