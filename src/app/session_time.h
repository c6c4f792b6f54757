// Time in the window: how fast it passes, and the last seconds of it to look back at.
#pragma once

#include "sim/rewind.h"
#include "sim/simulation.h"

namespace nuno {

class SessionTime
{
  public:
    // Simulated time passes at 1 / slowness() of the clock: 1, 2, 4, 8 or 16. The frames are the same.
    static constexpr int kMostSlowness = 16;
    int slowness() const { return slowness_; }
    void set_slowness(int slowness) { slowness_ = slowness; }

    // Whether frames are kept: at first they are. On the gpu backend each is copied from the device.
    bool keeps_frames() const { return keeps_; }
    // Frames from the present one on; where false, forgets all.
    void keep_frames(bool keep, Simulation& simulation);

    // To call after the start and after each frame.
    void note_frame(Simulation& simulation);
    // The scene was started.
    void begin(Simulation& simulation);
    const Rewind& frames() const { return frames_; }
    // Puts the simulation at the kept frame nearest to this one. False where none is kept. The next frame that is
    // simulated forgets those after it.
    bool show(Simulation& simulation, int frame) const;

  private:
    bool keeps_ = true;
    Rewind frames_;
    int slowness_ = 1;
};

}  // namespace nuno
