// What is left to nuno among the parameters.
#include "solver/method_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "model/face_table.h"
#include "model/stability.h"

namespace nuno {
namespace {

// Where no number of substeps holds: a membrane stretched beyond measure, a method without damping.
constexpr int kMostSubsteps = 10000, kSomeSubsteps = 20;

// Between pins that move apart threads are pulled by more than their weight: so many times the substeps halve it.
constexpr double kPulled = 2;

// How much a membrane may be stretched further within a frame.
constexpr double kStretchInAFrame = 0.25;

// Vertices along the longest side of a sheet, as if it were square.
double side_of(const Sheet& sheet)
{
    return sheet.is_grid() ? std::max(sheet.columns, sheet.rows) : std::sqrt(double(sheet.vertex_count));
}

// The most that the wind presses on cloth at rest [N/m2].
double wind_load(const SimParams& p)
{
    if (p.wind_model == WindModel::sines) return std::abs(double(p.wind_mean)) + double(p.wind_strength);
    const double speed = std::hypot(double(p.wind_x), double(p.wind_y), double(p.wind_z)) + double(p.gust_speed);
    return 0.5 * double(p.air_density) * double(p.pressure_coefficient) * speed * speed;
}

// Pins of a sheet that move apart may be further from each other than the cloth reaches, which tethers would not yield
// to.
bool pins_move_apart(const ClothModel& model, const Bodies& bodies, const Sheet& sheet)
{
    constexpr std::uint32_t in_place = ~0u;
    std::optional<std::uint32_t> first;
    const auto is_other = [&](std::uint32_t carrier) {
        if (!first) first = carrier;
        return carrier != *first;
    };
    for (std::uint32_t v = sheet.first_vertex; v < sheet.first_vertex + sheet.vertex_count; ++v) {
        if (!model.pinned[v]) continue;
        const auto pin = std::find_if(model.handle_pins.begin(), model.handle_pins.end(),
                                      [&](const HandlePin& p) { return p.vertex == v; });
        const bool moves = pin != model.handle_pins.end() && bodies.handles[pin->handle].motion.moves();
        if (is_other(moves ? pin->handle : in_place)) return true;
    }
    return false;
}

bool pins_move_apart(const ClothModel& model, const Bodies& bodies)
{
    return !model.handle_pins.empty() && std::any_of(model.sheets.begin(), model.sheets.end(), [&](const Sheet& sheet) {
        return pins_move_apart(model, bodies, sheet);
    });
}

// Substeps a second of xpbd and vbd that leave a stiff sheet a strain of 3 % (docs/methods.md): where tethers to pins
// carry it, as measured; else as soft as springs of m / h^2 let it be, strain = load (N - 1) h^2 / (2 c cell), with c
// measured.
double sweeping_rate(const ClothModel& model, const Sheet& sheet, double load, bool tethered)
{
    constexpr double earth = 9.81, strain = 0.03, share = 0.25;
    const double side = side_of(sheet);
    const double hung = 60 * std::max(3.0, 6.4 * std::pow(side / 64, 0.7)) * std::max(1.0, std::sqrt(load / earth));
    const auto pins = model.pinned.begin() + sheet.first_vertex;
    if (tethered && std::any_of(pins, pins + sheet.vertex_count, [](std::uint8_t pin) { return pin != 0; }))
        return hung;
    const auto areas = model.areas.begin() + sheet.first_vertex;
    const double cells = sheet.is_grid() ? double(sheet.columns - 1) * (sheet.rows - 1) : double(sheet.vertex_count);
    const double cell = std::sqrt(std::accumulate(areas, areas + sheet.vertex_count, 0.0) / cells);
    return std::max(hung, std::sqrt(load * (side - 1) / (2 * share * strain * cell)));
}

int sweeping_substeps(const ClothModel& model, const Bodies& bodies, const SimParams& p)
{
    const double gravity = std::hypot(double(p.gravity_x), double(p.gravity_y), double(p.gravity_z));
    const double load = gravity + wind_load(p) / double(p.areal_density);
    double rate = 0;
    for (const Sheet& sheet : model.sheets)
        rate = std::max(rate, sweeping_rate(model, sheet, load, p.tethers != Tethers::none));
    if (pins_move_apart(model, bodies)) rate *= kPulled;
    return static_cast<int>(std::clamp(std::ceil(rate / p.frame_rate), 1.0, 1000.0));
}

// What automatic substeps of an explicit method allow for: springs stretched however far, a membrane some further than
// it is now.
double stretch_to_come(const SimParams& params, double stretch)
{
    if (params.internal_model == InternalModel::continuum) return stretch + kStretchInAFrame;
    return std::numeric_limits<double>::infinity();
}

// Substeps of the implicit methods. A body pushes out what a substep has moved into it, vertex by vertex, and strains
// the springs to the others: over the edge of a box stiff cloth took up energy at omega h = 11, and none at 7.
int implicit_substeps(const ClothModel& model, const Bodies& bodies, const SimParams& params)
{
    constexpr double most_omega_h = 6;
    const bool touches = bodies.shape_count() > 0;
    double rate = touches ? 960 : params.method == Method::implicit_euler ? 240 : 120;
    if (touches) rate = std::max(rate, omega_max_bound(model, params) / most_omega_h);
    return static_cast<int>(std::clamp(std::ceil(rate / params.frame_rate), 1.0, 1000.0));
}

int substeps_for(const ClothModel& model, const Bodies& bodies, const SimParams& params, double stretch)
{
    if (is_explicit(params.method)) {
        const int least = least_stable_substeps(model, params, stretch_to_come(params, stretch));
        if (least > 0) return least;
        return params.internal_model == InternalModel::continuum ? kMostSubsteps : kSomeSubsteps;
    }
    if (params.method == Method::xpbd || params.method == Method::vbd) return sweeping_substeps(model, bodies, params);
    if (params.method == Method::reference) return 1;
    return implicit_substeps(model, bodies, params);
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

}  // namespace

SimParams resolve_params(const ClothModel& model, const Bodies& bodies, const SimParams& asked, double stretch)
{
    if (face_forces(asked).membrane) membrane_constants(asked);  // Error where they are none
    SimParams params = asked;
    if (asked.method == Method::automatic) params.method = automatic_method(model, asked, stretch);
    const bool position_based = params.method == Method::xpbd || params.method == Method::vbd;
    if (asked.tethers == Tethers::automatic)
        params.tethers = position_based && !pins_move_apart(model, bodies) ? Tethers::pins : Tethers::none;
    if (asked.substeps == 0) params.substeps = substeps_for(model, bodies, params, stretch);
    return params;
}

}  // namespace nuno
