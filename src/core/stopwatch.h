// Wall-clock time of a stage.
#pragma once

#include <chrono>

namespace nuno {

class Stopwatch
{
  public:
    double elapsed_ms() const
    {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }
    // Milliseconds since the start or the last lap, and starts the next lap.
    double lap_ms()
    {
        const double ms = elapsed_ms();
        start_ = std::chrono::steady_clock::now();
        return ms;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace nuno
