// A value over the last simulated seconds, for plots.
#pragma once

#include <deque>

namespace nuno {

class ValueHistory
{
  public:
    static constexpr double kSeconds = 10;  // that are kept

    struct Sample
    {
        double time_s, value;
    };

    // Values that are no finite number are passed over. Samples at or after `time_s` are forgotten first: the run was
    // put back.
    void add(double time_s, double value);

    // By rising time.
    const std::deque<Sample>& samples() const { return samples_; }
    double lowest() const;  // 0 where there are none
    double highest() const;

  private:
    std::deque<Sample> samples_;
};

// The least of 1, 2, 5 times a power of ten that is not below `value`; 1 where that is not over 0.
double round_axis(double value);

}  // namespace nuno
