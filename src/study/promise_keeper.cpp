// Up and down the ladder.
#include "study/promise_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "study/doubling_error.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// An error is estimated after every so many frames; the root mean square of so many estimates counts, but two are enough.
constexpr int kSampleFrames = 20;
constexpr std::size_t kSamples = 4, kFewestSamples = 2;
// A cheaper rung has to keep this share of the error asked for, so many times in a row; twice as many after each change
// back, up to a limit.
constexpr double kCalmShare = 0.5;
constexpr int kPatience = 4, kMostPatience = 64;
// Strain beyond so many times what was measured, and this much more, is another motion than the one measured.
constexpr double kStrainTimes = 2, kStrainMore = 0.02;
// The median of so many frames is held against a budget; a dearer rung has to fit in this share of it, a cheaper one
// in that.
constexpr std::size_t kTimedFrames = 15;
constexpr double kRoomShare = 0.7, kFitShare = 0.9;
constexpr int kFramesOfPatience = 30;  // of a budget, for each of an error

double median(std::deque<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double root_mean_square(const std::deque<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / double(values.size()));
}

}  // namespace

bool AutoGoal::is_kept_by(double error, double ms) const
{
    return (!error_share || error <= *error_share) && (!budget_ms || ms <= *budget_ms);
}

bool is_chosen_by_auto(std::string_view name)
{
    for (const char* chosen : {"method", "substeps", "iterations", "tethers", "strain_limit", "backend"})
        if (name == chosen) return true;
    return false;
}

SimParams on_rung(SimParams params, const SimParams& base, const Setting& set)
{
    params.method = base.method;
    params.substeps = base.substeps;
    params.iterations = base.iterations;
    params.tethers = base.tethers;
    params.strain_limit = base.strain_limit;
    params.backend = Backend::cpu;
    return with_setting(params, set);
}

PromiseKeeper::PromiseKeeper(const AutoGoal& goal, std::vector<Rung> ladder, std::size_t chosen, const SimParams& base,
                             int horizon_frames)
    : goal_(goal), ladder_(std::move(ladder)), rung_(chosen), base_(base), horizon_frames_(horizon_frames)
{
    assert(chosen < ladder_.size());
    const Rung& rung = ladder_[rung_];
    is_too_hard_ = !goal_.is_kept_by(rung.error_share, rung.ms_per_frame);
    restart();
}

void PromiseKeeper::restart()
{
    changes_.clear();
    recent_.clear();
    estimates_.clear();
    told_of_layers_ = false;
    is_broken_ = is_too_hard_;
    told_ = is_too_hard_;
    patience_ = kPatience;
    unresolved_ = 0;
    calm_ = 0;
    next_sample_ = kSampleFrames / 2;
}

std::vector<std::string> PromiseKeeper::look(Simulation& simulation, const FrameStats& frame)
{
    if (frame.substeps == 0) {  // cloth asleep shows neither error nor cost
        next_sample_ = std::max(next_sample_, frame.frame + 1);
        return {};
    }
    unresolved_ += frame.count.unresolved;
    if (goal_.budget_ms) return look_at_cost(simulation, frame);
    if (frame.frame < next_sample_) return {};
    next_sample_ += kSampleFrames;
    return look_at_error(simulation, frame.frame);
}

// Over the horizon, if motion were as hard to follow all along as it is now.
double PromiseKeeper::predicted(std::size_t rung) const
{
    const double now = root_mean_square(recent_), measured = ladder_[rung_].doubling_m;
    if (!std::isfinite(now)) return std::numeric_limits<double>::infinity();
    return ladder_[rung].error_share * (measured > 0 ? now / measured : 1);
}

// Layers that went through one another, where more substeps allow more passes of collision: the rung that has some.
// Else what is to be said of them once.
std::optional<std::size_t> PromiseKeeper::rung_for_layers(const SimParams& params) const
{
    const int passes = most_passes(params), substeps = params.substeps;
    for (std::size_t to = rung_ + 1; passes > substeps && to < ladder_.size(); ++to)
        if (ladder_[to].substeps > substeps) return to;
    return std::nullopt;
}

std::vector<std::string> PromiseKeeper::look_at_error(Simulation& simulation, int frame)
{
    if (!pool_ || pool_->thread_count() != simulation.thread_count())
        pool_ = std::make_unique<ThreadPool>(simulation.thread_count());
    recent_.push_back(doubling_error_m(simulation, *pool_));
    if (recent_.size() > kSamples) recent_.pop_front();
    const double strain = simulation.diagnostics().max_strain, known = ladder_[rung_].largest_strain;
    const bool is_strained = strain > kStrainTimes * known + kStrainMore;
    if (!is_strained && unresolved_ == 0 && recent_.size() < kFewestSamples) return {};
    const double error = predicted(rung_), most = *goal_.error_share;
    estimates_.push_back(error);
    if (error > most || is_strained) {
        std::size_t to = rung_ + 1;
        while (to + 1 < ladder_.size() && predicted(to) > most) ++to;
        const std::string reason =
            error > most
                ? fmt::format("an error of about {:.2g} %, over {:g} %", 100 * error, 100 * most)
                : fmt::format("a strain of {:.2g} %, {:.2g} % at most when it was measured", 100 * strain, 100 * known);
        if (to < ladder_.size()) return move(simulation, to, reason, frame);
        return cannot(reason, horizon_frames_ == 0 || frame <= horizon_frames_);
    }
    if (std::exchange(unresolved_, 0) > 0) {
        const char* const reason = "layers went through one another";
        if (const auto to = rung_for_layers(simulation.params())) return move(simulation, *to, reason, frame);
        if (std::exchange(told_of_layers_, true)) return {};
        return {
            fmt::format("frame {}: {}; a higher level of collision prevents that, no setting in time", frame, reason)};
    }
    told_ = false;
    const bool would_do = rung_ > 0 && predicted(rung_ - 1) <= kCalmShare * most;
    calm_ = would_do ? calm_ + 1 : 0;
    if (calm_ < patience_) return {};
    return move(simulation, rung_ - 1,
                fmt::format("an error of about {:.2g} %, far below {:g} %", 100 * error, 100 * most), frame);
}

std::vector<std::string> PromiseKeeper::look_at_cost(Simulation& simulation, const FrameStats& frame)
{
    recent_.push_back(simulation_ms(frame.stage_ms));
    estimates_.push_back(recent_.back());
    if (recent_.size() > kTimedFrames) recent_.pop_front();
    if (recent_.size() < kTimedFrames) return {};
    const double ms = median(recent_), most = *goal_.budget_ms;
    const auto cost = [&](std::size_t rung) { return ladder_[rung].ms_per_frame * ms / ladder_[rung_].ms_per_frame; };
    if (ms > most) {
        const std::string reason = fmt::format("{:.3g} ms a frame, over {:g}", ms, most);
        if (rung_ == 0) return cannot(reason, true);
        std::size_t to = rung_ - 1;
        while (to > 0 && cost(to) > kFitShare * most) --to;
        return move(simulation, to, reason, frame.frame);
    }
    told_ = false;
    const bool has_room = rung_ + 1 < ladder_.size() && cost(rung_ + 1) <= kRoomShare * most;
    calm_ = has_room ? calm_ + 1 : 0;
    if (calm_ < patience_ * kFramesOfPatience) return {};
    return move(simulation, rung_ + 1, fmt::format("{:.3g} ms a frame, far below {:g}", ms, most), frame.frame);
}

std::vector<std::string> PromiseKeeper::move(Simulation& simulation, std::size_t to, const std::string& reason,
                                             int frame)
{
    const Rung &before = ladder_[rung_], &after = ladder_[to];
    simulation.set_params(on_rung(simulation.asked_params(), base_, after.set));
    // What calm allowed did not do: wait longer the next time.
    const auto is_relief = [&](std::size_t a, std::size_t b) { return goal_.budget_ms ? b < a : b > a; };
    const bool was_calm = !changes_.empty() && !is_relief(changes_.back().from, changes_.back().to);
    if (was_calm && is_relief(rung_, to)) patience_ = std::min(2 * patience_, kMostPatience);
    changes_.push_back({frame, rung_, to, reason});
    rung_ = to;
    recent_.clear();
    unresolved_ = 0;
    calm_ = 0;
    told_ = false;
    return {
        fmt::format("frame {}: {}: goes on with {}; measured error {:.2g} % instead of {:.2g} %, {:.3g} ms a frame "
                    "instead of {:.3g}",
                    frame, reason, setting_text(after.set), 100 * after.error_share, 100 * before.error_share,
                    after.ms_per_frame, before.ms_per_frame)};
}

std::vector<std::string> PromiseKeeper::cannot(const std::string& reason, bool counts)
{
    is_broken_ = is_broken_ || counts;
    unresolved_ = 0;
    calm_ = 0;
    if (std::exchange(told_, true)) return {};
    return {fmt::format("{}: the promise cannot be kept, and no {} setting is known", reason,
                        goal_.budget_ms ? "cheaper" : "more exact")};
}

std::optional<double> PromiseKeeper::latest() const
{
    return estimates_.empty() ? std::nullopt : std::optional(estimates_.back());
}

bool PromiseKeeper::is_kept() const
{
    if (!goal_.budget_ms || estimates_.empty()) return !is_broken_;
    return median({estimates_.begin(), estimates_.end()}) <= *goal_.budget_ms;
}

std::string PromiseKeeper::verdict() const
{
    if (is_kept()) return "";
    if (estimates_.empty()) return "the promise is not kept: no setting that was measured keeps it";
    if (goal_.budget_ms)
        return fmt::format("the promise is not kept: the median frame took {:.3g} ms, over {:g}",
                           median({estimates_.begin(), estimates_.end()}), *goal_.budget_ms);
    return fmt::format("the promise is not kept: {} of {} estimates of the error are over {:g} %", looks_over(),
                       estimates_.size(), 100 * *goal_.error_share);
}

std::ptrdiff_t PromiseKeeper::looks_over() const
{
    const double most = goal_.error_share ? *goal_.error_share : *goal_.budget_ms;
    return std::count_if(estimates_.begin(), estimates_.end(), [&](double value) { return value > most; });
}

Json PromiseKeeper::report() const
{
    const bool is_error = goal_.error_share.has_value();
    const double most = is_error ? *goal_.error_share : *goal_.budget_ms;
    Json changes = Json::array();
    for (const RungChange& change : changes_)
        changes.push_back({{"frame", change.frame},
                           {"from", setting_text(ladder_[change.from].set)},
                           {"to", setting_text(ladder_[change.to].set)},
                           {"reason", change.reason}});
    const double largest = estimates_.empty() ? 0 : *std::max_element(estimates_.begin(), estimates_.end());
    return {{"of", is_error ? "error_share" : "ms_per_frame"},
            {"most", most},
            {"kept", is_kept()},
            {"looks", estimates_.size()},
            {"looks_over", looks_over()},
            {"largest", std::isfinite(largest) ? Json(largest) : Json(nullptr)},
            {"changes", changes}};
}

}  // namespace nuno
