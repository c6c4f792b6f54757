// Quantiles of a list of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace nuno {

// Of the values, sorted, the one at place share * count, rounded down; `share` 0..1. 0 where there are none.
inline double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return 0;
    const std::size_t place = std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace nuno
