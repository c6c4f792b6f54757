// What is left to nuno among the parameters.
#include "solver/method_choice.h"

#include <algorithm>
#include <cmath>

#include "model/face_table.h"
#include "model/stability.h"

namespace nuno {
namespace {

// Vertices along the longest side of the largest sheet, as if it were square.
double side_of(const ClothModel& model)
{
    double side = 1;
    for (const Sheet& sheet : model.sheets) {
        const double longest = sheet.is_grid() ? std::max(sheet.columns, sheet.rows) : std::sqrt(sheet.vertex_count);
        side = std::max(side, longest);
    }
    return side;
}

// The most that the wind presses on cloth at rest [N/m2].
double wind_load(const SimParams& p)
{
    if (p.wind_model == WindModel::sines) return std::abs(double(p.wind_mean)) + double(p.wind_strength);
    const double speed = std::hypot(double(p.wind_x), double(p.wind_y), double(p.wind_z)) + double(p.gust_speed);
    return 0.5 * double(p.air_density) * double(p.pressure_coefficient) * speed * speed;
}

// Substeps of xpbd and vbd that keep the strain of a stiff sheet hung by two corners under 3 % (docs/methods.md), more
// under more than the earth's load.
int sweeping_substeps(const ClothModel& model, const SimParams& p)
{
    const double least = std::max(3.0, 6.4 * std::pow(side_of(model) / 64, 0.7));
    const double gravity = std::hypot(double(p.gravity_x), double(p.gravity_y), double(p.gravity_z));
    const double load = std::max(1.0, std::sqrt((gravity + wind_load(p) / double(p.areal_density)) / 9.81));
    return static_cast<int>(std::min(std::ceil(least * load), 1000.0));
}

int substeps_for(const ClothModel& model, const SimParams& params)
{
    if (is_explicit(params.method)) {
        const int least = least_stable_substeps(model, params);
        return least > 0 ? least : 20;
    }
    if (params.method == Method::xpbd || params.method == Method::vbd) return sweeping_substeps(model, params);
    if (params.method == Method::implicit_euler) return 4;
    return params.method == Method::sdirk2 ? 2 : 1;
}

}  // namespace

SimParams resolve_params(const ClothModel& model, const SimParams& asked)
{
    if (face_forces(asked).membrane) membrane_constants(asked);  // Error where they are none
    SimParams params = asked;
    if (asked.method == Method::automatic) {
        params.method = Method::symplectic_euler;
        const int least = least_stable_substeps(model, params);
        const int most = asked.substeps > 0 ? asked.substeps : kMostExplicitSubsteps;
        const bool bounded =
            asked.strain_limit > 0 || asked.tethers == Tethers::pins || asked.tethers == Tethers::contacts;
        const bool stable = least > 0 && least <= most;
        const bool beyond_xpbd = asked.internal_model == InternalModel::continuum || asked.stiffness_damping > 0;
        if ((bounded || !stable) && !beyond_xpbd) params.method = Method::xpbd;
    }
    if (asked.substeps == 0) params.substeps = substeps_for(model, params);
    const bool position_based = params.method == Method::xpbd || params.method == Method::vbd;
    if (asked.tethers == Tethers::automatic) params.tethers = position_based ? Tethers::pins : Tethers::none;
    return params;
}

}  // namespace nuno
