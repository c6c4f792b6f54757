// Rates, renewed twice a second.
#include "app/viewer_pace.h"

namespace nuno {

constexpr double kRenewAfterS = 0.5;

void ViewerPace::add(double elapsed_s, double simulated_s)
{
    elapsed_s_ += elapsed_s;
    simulated_s_ += simulated_s;
    ++frames_;
    if (elapsed_s_ < kRenewAfterS) return;
    frames_per_second_ = frames_ / elapsed_s_;
    real_time_factor_ = simulated_s_ / elapsed_s_;
    elapsed_s_ = simulated_s_ = 0;
    frames_ = 0;
}

}  // namespace nuno
