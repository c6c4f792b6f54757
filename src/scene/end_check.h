// The check that ends a scene: bounds on what the whole run measured.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nuno {

// What a run measures, over all its frames unless "final" is in the name. SI units.
struct RunMetrics
{
    double frames = 0;
    double contacts = 0, peak_contacts = 0;  // all, and most in one pass
    double passed_through = 0;               // vertex-face pairs, where count_pass_through is on
    double peak_strain = 0, final_strain = 0;
    double peak_speed = 0, final_speed = 0;
    double final_lowest = 0, final_highest = 0;  // y of the bounding box
    double lowest = 0;                           // least y of any frame
    double final_kinetic_j = 0;
};

struct MetricInfo
{
    std::string_view name, help;
    double RunMetrics::*value;
};
std::span<const MetricInfo> metric_table();

// min <= metric <= max.
struct MetricBound
{
    const MetricInfo* metric;
    double min, max;
    std::string where;  // file and line
};

struct EndCheck
{
    int frames = 0;  // the frame at which it applies; 0: no check
    std::vector<MetricBound> bounds;
};

// One sentence for each bound that does not hold; empty where all do.
std::vector<std::string> failed_bounds(const EndCheck& check, const RunMetrics& metrics);

}  // namespace nuno
