// A ring of saved states.
#include "sim/rewind.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace nuno {

void Rewind::clear()
{
    frames_.clear();
    bytes_ = 0;
}

void Rewind::keep(Simulation& simulation)
{
    const int frame = simulation.frame();
    while (!frames_.empty() && frames_.back().frame >= frame) {
        bytes_ -= frames_.back().size_bytes();
        frames_.pop_back();
    }
    const bool follows = !frames_.empty() && frames_.back().frame + 1 == frame &&
                         frames_.back().cloth.positions.size() == simulation.model().vertex_count();
    if (!follows) clear();
    frames_.push_back(simulation.save());
    bytes_ += frames_.back().size_bytes();
    while (frames_.size() > 1 &&
           (bytes_ > limits_.bytes || frames_.back().time_s - frames_.front().time_s > limits_.seconds))
        forget_oldest();
}

void Rewind::forget_oldest()
{
    bytes_ -= frames_.front().size_bytes();
    frames_.pop_front();
}

const SavedState& Rewind::show(Simulation& simulation, int frame) const
{
    assert(!empty());
    const int at = std::clamp(frame, first_frame(), last_frame()) - first_frame();
    const SavedState& saved = frames_[static_cast<std::size_t>(at)];
    simulation.resume(saved);
    return saved;
}

void Rewind::resume(Simulation& simulation, int frame)
{
    const int at = show(simulation, frame).frame;
    while (last_frame() > at) {
        bytes_ -= frames_.back().size_bytes();
        frames_.pop_back();
    }
}

}  // namespace nuno
