// How fast the viewer runs: frames shown a second, and simulated time against the clock.
#pragma once

namespace nuno {

class ViewerPace
{
  public:
    // A frame was shown `elapsed_s` after the one before, and showed `simulated_s` more of simulated time.
    void add(double elapsed_s, double simulated_s);

    double frames_per_second() const { return frames_per_second_; }
    double real_time_factor() const { return real_time_factor_; }

  private:
    double elapsed_s_ = 0, simulated_s_ = 0;  // since the last result
    int frames_ = 0;
    double frames_per_second_ = 0, real_time_factor_ = 0;
};

}  // namespace nuno
