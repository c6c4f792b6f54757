// Values over time.
#include "app/value_history.h"

#include <algorithm>
#include <cmath>

#include "core/round_up.h"

namespace nuno {
namespace {

bool is_lower(const ValueHistory::Sample& a, const ValueHistory::Sample& b) { return a.value < b.value; }

}  // namespace

void ValueHistory::add(double time_s, double value)
{
    if (!std::isfinite(value)) return;
    while (!samples_.empty() && samples_.back().time_s >= time_s) samples_.pop_back();
    samples_.push_back({time_s, value});
    while (samples_.front().time_s < time_s - kSeconds) samples_.pop_front();
}

double ValueHistory::lowest() const
{
    return samples_.empty() ? 0 : std::min_element(samples_.begin(), samples_.end(), is_lower)->value;
}

double ValueHistory::highest() const
{
    return samples_.empty() ? 0 : std::max_element(samples_.begin(), samples_.end(), is_lower)->value;
}

double round_axis(double value) { return value > 0 ? round_up_125(value) : 1; }

}  // namespace nuno
