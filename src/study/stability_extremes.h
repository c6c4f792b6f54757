// The extremes: what becomes of a cloth at the ends of what can be asked for, case by case, against what is expected.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "study/sweep.h"

namespace nuno {

enum class Outcome : std::int32_t
{
    finite,    // every number of every frame is one
    refused,   // a message before the start, exit code 2
    went_bad,  // the run ended with a message, exit code 3
    too_long,  // it took a minute and was given up
    unseen,    // a number was lost and nobody said so
    crashed    // anything else that was thrown
};
std::string_view name_of(Outcome outcome);

// What is asked of a cloth.
enum class Extreme : std::int32_t
{
    stiffness,         // times the scene's
    air_damping,       // damping ratio at the highest mode
    rayleigh_damping,  // the same by stiffness_damping
    long_substep,      // [s], one a frame; chosen: the frame

    mass_ratio,  // of neighbours
    sliver,      // width of a row of faces over their length
    no_area,     // of one face
    coincident,  // vertices: 0 at the ends of an edge, 1 of two patches along a seam
    pin_jump,    // of all pins in a step [m]
    speed,       // of all vertices at the start [m/s]
    gravity,     // times the earth's
    wind,        // [m/s]
    far_away,    // from the origin [m]
    many_steps   // substeps
};

struct ExtremeCase
{
    std::string id;    // "extreme/stiffness_1e+06/xpbd/chosen"
    std::string what;  // for people
    Extreme extreme;
    double value;
    Method method;
    bool chosen_substeps;  // by nuno; else the scene's, whatever they lead to

    // What may become of it.
    bool expects(Outcome outcome) const;
    std::string expected() const;
};

// All cases for these methods.
std::vector<ExtremeCase> extreme_cases(const std::vector<Method>& methods);

// Runs one: {outcome, as_expected, said, frames, substeps, max_strain, max_speed}.
nlohmann::ordered_json measure_extreme(const Scene& scene, const SimParams& params, const ExtremeCase& extreme);

std::vector<SweepPoint> extreme_points(const Scene& scene, const SimParams& params,
                                       const std::vector<ExtremeCase>& cases);

}  // namespace nuno
