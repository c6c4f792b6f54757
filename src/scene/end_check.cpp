// Bounds on what a run measured.
#include "scene/end_check.h"

#include <fmt/format.h>

namespace nuno {

std::span<const MetricInfo> metric_table()
{
    static constexpr MetricInfo table[] = {
        {"contacts", "vertex-face contacts of all passes", &RunMetrics::contacts},
        {"peak_contacts", "most contacts in one pass", &RunMetrics::peak_contacts},
        {"passed_through", "vertices that passed through a face between two passes", &RunMetrics::passed_through},
        {"peak_strain", "largest structural strain of any frame", &RunMetrics::peak_strain},
        {"final_strain", "largest structural strain of the last frame", &RunMetrics::final_strain},
        {"peak_speed", "largest speed of any frame [m/s]", &RunMetrics::peak_speed},
        {"final_speed", "largest speed of the last frame [m/s]", &RunMetrics::final_speed},
        {"lowest", "least y of any frame [m]", &RunMetrics::lowest},
        {"final_lowest", "least y of the last frame [m]", &RunMetrics::final_lowest},
        {"final_highest", "largest y of the last frame [m]", &RunMetrics::final_highest},
        {"final_kinetic_j", "kinetic energy of the last frame [J]", &RunMetrics::final_kinetic_j},
    };
    return table;
}

std::vector<std::string> failed_bounds(const EndCheck& check, const RunMetrics& metrics)
{
    std::vector<std::string> failures;
    for (const MetricBound& bound : check.bounds) {
        const double value = metrics.*bound.metric->value;
        if (value >= bound.min && value <= bound.max) continue;  // false for a NaN, which fails
        failures.push_back(fmt::format("{}: {} is {:.6g}, expected {:g} to {:g}", bound.where, bound.metric->name,
                                       value, bound.min, bound.max));
    }
    return failures;
}

}  // namespace nuno
