// What the session of the viewer does for the slider from fast to accurate.
#include <fmt/format.h>

#include "app/viewer_session.h"
#include "core/error.h"

namespace nuno {

std::optional<std::size_t> ViewerSession::rung() const
{
    return promise_ ? promise_->rung() : trade_.rung_of(simulation_->asked_params());
}

void ViewerSession::measure_ladder()
{
    trade_.measure(simulation_->scene(), simulation_->asked_params());
    log_.action("{}", trade_.is_measuring() ? "measuring" : "ladder remembered");
}

void ViewerSession::give_up_measuring()
{
    if (!trade_.is_measuring()) return;
    trade_.give_up();
    log_.action("measuring given up");
}

bool ViewerSession::follow_measuring()
{
    const TradeSlider::News news = trade_.follow();
    if (news != TradeSlider::News::done) return news == TradeSlider::News::progress;
    if (trade_.ladder())
        log_.action("ladder of {} rungs measured", trade_.ladder()->rungs.size());
    else
        log_.action("measuring failed: {}", trade_.error());
    if (trade_.ladder() && trade_.is_for_promise()) begin_promise();
    return true;
}

// The cloth rested until now, so that it moves as it would have with this setting from its start.
void ViewerSession::begin_promise()
{
    const MeasuredLadder& ladder = *trade_.ladder();
    const Rung& chosen = ladder.rungs[ladder.chosen];
    if (!set_rung(ladder.chosen)) return;
    promise_ = std::make_unique<PromiseKeeper>(ladder.keeper());
    if (quiet_) return;
    const std::string& name = simulation_->scene().name;
    fmt::print(stderr, "{}: {}\n", name, setting_text(chosen.set, "--set "));
    for (const std::string& sentence : ladder.given_up) fmt::print(stderr, "{}: given up: {}\n", name, sentence);
    if (!ladder.is_kept)
        fmt::print(stderr, "nuno: {}: the promise cannot be kept: of all that was tried this is the nearest\n", name);
}

void ViewerSession::use_rung(std::size_t rung)
{
    const SimParams before = simulation_->asked_params();
    if (!set_rung(rung)) return;
    promise_.reset();
    const SimParams after = simulation_->asked_params();
    history_.record("speed and accuracy", changes_between(sim_param_table(), &before, &after), true);
}

// Whether it did; where not, the error is told.
bool ViewerSession::set_rung(std::size_t rung)
{
    const MeasuredLadder& ladder = *trade_.ladder();
    try {
        simulation_->set_params(on_rung(simulation_->asked_params(), ladder.base, ladder.rungs[rung].set));
        log_.action("rung {} of {}: {}", rung + 1, ladder.rungs.size(), setting_text(ladder.rungs[rung].set));
        if (!went_bad_) error_.clear();
        trade_.forget_frames();
        judge_stability();
        return true;
    } catch (const std::exception& error) {
        note_error(error);
        return false;
    }
}

}  // namespace nuno
