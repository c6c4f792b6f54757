// Time in the window.
#include "app/session_time.h"

namespace nuno {

void SessionTime::keep_frames(bool keep, Simulation& simulation)
{
    keeps_ = keep;
    begin(simulation);
}

void SessionTime::note_frame(Simulation& simulation)
{
    if (keeps_) frames_.keep(simulation);
}

void SessionTime::begin(Simulation& simulation)
{
    frames_.clear();
    note_frame(simulation);
}

bool SessionTime::show(Simulation& simulation, int frame) const
{
    if (frames_.empty()) return false;
    frames_.show(simulation, frame);
    return true;
}

}  // namespace nuno
