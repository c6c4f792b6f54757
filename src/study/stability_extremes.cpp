// The cases, and what is expected of each.
#include "study/stability_extremes.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/oscillator.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

struct ExtremeInfo
{
    Extreme extreme;
    std::string_view id, what;  // what: with the value in place of {}
    std::vector<double> values;
};

const std::vector<ExtremeInfo>& extremes()
{
    static const std::vector<ExtremeInfo> all{
        {Extreme::stiffness, "stiffness", "stiffness times {}", {1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}},
        {Extreme::air_damping, "air_damping", "a damper of the air with the ratio {} at the highest mode", {2}},
        {Extreme::rayleigh_damping, "rayleigh_damping", "Rayleigh damping with the ratio {} at the highest mode", {2}},
        {Extreme::long_substep, "long_substep", "frames of {} s", {1.0 / 15}},
        {Extreme::mass_ratio, "mass_ratio", "masses of neighbours as {} to 1", {1e2, 1e4}},
        {Extreme::sliver, "sliver", "a row of triangles {} as wide as long", {1e-6}},
        {Extreme::no_area, "no_area", "a triangle without area", {0}},
        {Extreme::coincident, "coincident", "two vertices in one place ({})", {0, 1}},
        {Extreme::pin_jump, "pin_jump", "all pins jump {} m in a step", {1}},
        {Extreme::speed, "speed", "all vertices start at {} m/s", {1e3}},
        {Extreme::gravity, "gravity", "{} times the gravity of the earth", {1e3}},
        {Extreme::wind, "wind", "wind of {} m/s", {100}},
        {Extreme::far_away, "far_away", "{} m from the origin", {1e4}},
        {Extreme::many_steps, "many_steps", "{} substeps", {1e6}}};
    return all;
}

bool is_refused(const ExtremeCase& c)
{
    if (c.extreme == Extreme::rayleigh_damping) return !method_info(c.method).takes_dampers;
    return c.extreme == Extreme::no_area || (c.extreme == Extreme::coincident && c.value == 0);
}

}  // namespace

std::string_view name_of(Outcome outcome)
{
    constexpr std::string_view names[] = {"finite", "refused", "went_bad", "too_long", "unseen", "crashed"};
    return names[std::size_t(outcome)];
}

// An explicit method with the substeps that were asked for may be beyond its limit, and must say so.
bool ExtremeCase::expects(Outcome outcome) const
{
    if (is_refused(*this)) return outcome == Outcome::refused;
    return outcome == Outcome::finite || (is_explicit(method) && outcome == Outcome::went_bad);
}

std::string ExtremeCase::expected() const
{
    if (is_refused(*this)) return "refused";
    return is_explicit(method) ? "finite or went_bad" : "finite";
}

std::vector<ExtremeCase> extreme_cases(const std::vector<Method>& methods)
{
    std::vector<ExtremeCase> cases;
    for (const ExtremeInfo& info : extremes())
        for (const double value : info.values)
            for (const Method method : methods)
                for (const bool chosen : {true, false}) {
                    if (info.extreme == Extreme::many_steps && !chosen) continue;
                    cases.push_back({fmt::format("extreme/{}_{:g}/{}/{}", info.id, value, method_info(method).name,
                                                 chosen ? "chosen" : "given"),
                                     fmt::format(fmt::runtime(info.what), fmt::format("{:g}", value)), info.extreme,
                                     value, method, chosen});
                }
    return cases;
}

std::vector<SweepPoint> extreme_points(const Scene& scene, const SimParams& params,
                                       const std::vector<ExtremeCase>& cases)
{
    std::vector<SweepPoint> points;
    for (const ExtremeCase& c : cases)
        points.push_back({c.id, [&scene, params, c] { return measure_extreme(scene, params, c); }});
    return points;
}

}  // namespace nuno
