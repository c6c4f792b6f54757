// The last seconds of a run, to be looked at and gone on from.
#pragma once

#include <cstddef>
#include <deque>

#include "sim/simulation.h"

namespace nuno {

class Rewind
{
  public:
    struct Limits
    {
        std::size_t bytes = std::size_t(256) << 20;
        double seconds = 10;  // simulated
    };
    Rewind() = default;
    explicit Rewind(const Limits& limits) : limits_(limits) {}

    // To call after the start and after every frame: keeps the run as it is, which copies the cloth from the device,
    // and forgets the oldest frames beyond the limits, but never the newest. Where the frame is not the one after the
    // newest, frames from it on are forgotten first; where the cloth is another or there is a gap, all are.
    void keep(Simulation& simulation);
    void clear();

    // Numbers of the frames kept, without a gap: first_frame() .. last_frame(). Not to be asked where empty().
    bool empty() const { return frames_.empty(); }
    int first_frame() const { return frames_.front().frame; }
    int last_frame() const { return frames_.back().frame; }
    std::size_t frame_count() const { return frames_.size(); }
    std::size_t size_bytes() const { return bytes_; }

    // Puts the simulation at a frame that is kept, or else at the nearest one, to be looked at; all frames stay kept.
    const SavedState& show(Simulation& simulation, int frame) const;
    // The same to go on from there, with the same bits as the first time where the parameters are those of then;
    // forgets the frames after it.
    void resume(Simulation& simulation, int frame);

  private:
    void forget_oldest();

    Limits limits_;
    std::deque<SavedState> frames_;
    std::size_t bytes_ = 0;
};

}  // namespace nuno
