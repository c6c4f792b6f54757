// What is left to nuno among the parameters.
#include "solver/method_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/face_table.h"
#include "model/stability.h"

namespace nuno {
namespace {

// How much a membrane may be stretched further within a frame.
constexpr double kStretchInAFrame = 0.25;

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

// What automatic substeps of an explicit method allow for: springs stretched however far, a membrane some further than
// it is now.
double stretch_to_come(const SimParams& params, double stretch)
{
    if (params.internal_model == InternalModel::continuum) return stretch + kStretchInAFrame;
    return std::numeric_limits<double>::infinity();
}

int substeps_for(const ClothModel& model, const SimParams& params, double stretch)
{
    if (is_explicit(params.method)) {
        const int least = least_stable_substeps(model, params, stretch_to_come(params, stretch));
        return least > 0 ? least : 20;
    }
    if (params.method == Method::xpbd || params.method == Method::vbd) return sweeping_substeps(model, params);
    if (params.method == Method::implicit_euler) return 4;
    return params.method == Method::sdirk2 ? 2 : 1;
}

Method automatic_method(const ClothModel& model, SimParams params, double stretch)
{
    params.method = Method::symplectic_euler;
    if (params.internal_model == InternalModel::continuum || params.stiffness_damping > 0) return params.method;
    if (params.strain_limit > 0 || params.tethers == Tethers::pins || params.tethers == Tethers::contacts)
        return Method::xpbd;
    const int least = params.substeps > 0 ? least_stable_substeps(model, params)
                                          : least_stable_substeps(model, params, stretch_to_come(params, stretch));
    const int most = params.substeps > 0 ? params.substeps : kMostExplicitSubsteps;
    return least > 0 && least <= most ? params.method : Method::xpbd;
}

// Pins that move apart may be further from each other than the cloth reaches, which tethers would not yield to.
bool pins_move_apart(const ClothModel& model)
{
    const auto pins = std::size_t(std::count(model.pinned.begin(), model.pinned.end(), true));
    const bool fixed = pins > model.handle_pins.size();
    const auto other = [&](const HandlePin& pin) { return pin.handle != model.handle_pins.front().handle; };
    return !model.handle_pins.empty() &&
           (fixed || std::any_of(model.handle_pins.begin(), model.handle_pins.end(), other));
}

}  // namespace

SimParams resolve_params(const ClothModel& model, const SimParams& asked, double stretch)
{
    if (face_forces(asked).membrane) membrane_constants(asked);  // Error where they are none
    SimParams params = asked;
    if (asked.method == Method::automatic) params.method = automatic_method(model, asked, stretch);
    if (asked.substeps == 0) params.substeps = substeps_for(model, params, stretch);
    const bool position_based = params.method == Method::xpbd || params.method == Method::vbd;
    if (asked.tethers == Tethers::automatic)
        params.tethers = position_based && !pins_move_apart(model) ? Tethers::pins : Tethers::none;
    return params;
}

}  // namespace nuno
