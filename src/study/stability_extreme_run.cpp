// Runs of the extremes: those that a scene can say by the whole program, the others by a solver alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/stopwatch.h"
#include "model/diagnostics.h"
#include "model/oscillator.h"
#include "model/stability.h"
#include "sim/simulation.h"
#include "sim/stability_advice.h"
#include "solver/method_choice.h"
#include "solver/method_table.h"
#include "study/stability_cloth.h"
#include "study/stability_extremes.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFrames = 12, kMostSubsteps = 20000;
constexpr double kTooLongMs = 60000;

struct Record
{
    Outcome outcome = Outcome::finite;
    std::string said;
    int frames = 0, substeps = 0;
    double max_strain = 0, max_speed = 0;
    Stopwatch watch;

    // Whether to go on after a frame.
    bool looks_well(const ClothModel& model, const ClothState& state, const SimParams& params)
    {
        ++frames;
        substeps += params.substeps;
        if (first_lost(state.positions) || first_lost(state.velocities)) {
            outcome = Outcome::unseen;
            return false;
        }
        const Diagnostics now = measure(model, state, params);
        max_strain = std::max(max_strain, now.max_strain);
        max_speed = std::max(max_speed, now.max_speed);
        if (watch.elapsed_ms() > kTooLongMs) outcome = Outcome::too_long;
        return outcome == Outcome::finite;
    }
};

double highest_frequency(const Scene& scene, const SimParams& params)
{
    const ClothModel model = build_cloth_model(make_sheets(scene, params), params.mass_lumping);
    return rest_cloth(model, params, {}).omega;
}

SimParams params_of(const Scene& scene, SimParams p, const ExtremeCase& c)
{
    p.method = c.method;
    p.backend = Backend::cpu;
    p.threads = 1;
    p.collision = CollisionLevel::none;
    p.count_pass_through = false;
    p.tethers = Tethers::automatic;
    p.strain_limit = 0;
    p.sleep_motion = 0;
    p.substeps = c.chosen_substeps ? 0 : std::max(p.substeps, 20);
    switch (c.extreme) {
    case Extreme::stiffness: scale_stiffness(p, c.value); break;
    case Extreme::air_damping:
        p.damping = static_cast<float>(2 * c.value * highest_frequency(scene, p) * double(p.areal_density));
        break;
    case Extreme::rayleigh_damping:
        p.stiffness_damping = static_cast<float>(2 * c.value / highest_frequency(scene, p));
        break;
    case Extreme::long_substep:
        p.frame_rate = static_cast<int>(std::lround(1 / c.value));
        if (!c.chosen_substeps) p.substeps = 1;
        break;
    case Extreme::gravity: p.gravity_y = static_cast<float>(-9.81 * c.value); break;
    case Extreme::wind:
        p.wind_model = WindModel::aero;
        p.wind_z = static_cast<float>(c.value);
        break;
    case Extreme::many_steps:
        p.resolution = 3;
        if (!is_explicit(c.method)) p.frame_rate = 1;  // so that frames are few
        break;
    default: break;
    }
    return p;
}

// All pins on a handle that is in one place at the start and far from it right after.
void let_pins_jump(Scene& scene, double way)
{
    Handle jump;
    jump.name = "jump";
    jump.motion.keyframes = {{.time_s = 0.02}, {.time_s = 0.020001, .move = {way, 0, 0}}};
    jump.motion.easing = Easing::linear;
    scene.bodies.handles.push_back(jump);
    for (SheetSpec& sheet : scene.sheets) {
        if (sheet.pins.empty()) sheet.pins.push_back({sheet.where, "", {}, {0}});
        for (PinSpec& pins : sheet.pins) pins.handle = jump.name;
    }
}

void run_scene(Scene scene, const SimParams& params, const ExtremeCase& c, Record& record)
{
    if (c.extreme == Extreme::pin_jump) let_pins_jump(scene, c.value);
    if (c.extreme == Extreme::far_away)
        for (SheetSpec& sheet : scene.sheets) sheet.origin.x += static_cast<float>(c.value);
    Simulation simulation(std::move(scene), params);
    const int substeps = simulation.params().substeps;
    int frames = std::clamp(kMostSubsteps / substeps, 2, kFrames);
    if (c.extreme == Extreme::many_steps) frames = static_cast<int>(std::ceil(c.value / substeps));
    while (record.frames < frames) {
        simulation.advance_frame();
        if (!record.looks_well(simulation.model(), simulation.state(), simulation.params())) return;
    }
}

// 9 rows and columns of 1/8 m, one corner pinned; a row is as narrow as asked for, or vertices coincide.
SheetSource odd_sheet(const ExtremeCase& c)
{
    constexpr int side = 9;
    SheetSource sheet;
    sheet.mesh = grid_mesh(side, side, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
    sheet.pins = {0};
    std::vector<glm::vec3>& positions = sheet.mesh.positions;
    if (c.extreme == Extreme::sliver)
        for (int i = 0; i < side; ++i) positions[std::size_t(side + i)].y = static_cast<float>(-0.125 * c.value);
    if (c.extreme == Extreme::no_area)
        positions[1] = 0.5f * (positions[0] + positions[2]), positions[10] = positions[1];
    if (c.extreme == Extreme::coincident && c.value == 0) positions[41] = positions[40];
    if (c.extreme == Extreme::coincident && c.value == 1) {
        const TriangleMesh left = sheet.mesh;
        for (const glm::vec3& p : left.positions) positions.push_back(p + glm::vec3(1, 0, 0));
        for (const glm::uvec3& face : left.faces) sheet.mesh.faces.push_back(face + 81u);
        sheet.mesh.uvs.insert(sheet.mesh.uvs.end(), left.uvs.begin(), left.uvs.end());
        sheet.pins.push_back(81);
    }
    return sheet;
}

ClothModel odd_model(const Scene& scene, const SimParams& params, const ExtremeCase& c)
{
    if (c.extreme == Extreme::mass_ratio || c.extreme == Extreme::speed) {
        ClothModel model = build_cloth_model(make_sheets(scene, params), params.mass_lumping);
        if (c.extreme == Extreme::mass_ratio) make_every_other_lighter(model, c.value);
        return model;
    }
    const SheetSource sheet = odd_sheet(c);
    return build_cloth_model(std::span(&sheet, 1), MassLumping::area);
}

void run_solver(const Scene& scene, const SimParams& asked, const ExtremeCase& c, Record& record)
{
    const ClothModel model = odd_model(scene, asked, c);
    const SimParams params = resolve_params(model, scene.bodies, asked);
    ThreadPool pool(1);
    const auto solver = make_solver(model, scene.bodies, params, pool);
    ClothState state = start_state(model, params);
    if (c.extreme == Extreme::speed)
        for (std::size_t v = 0; v < state.velocities.size(); ++v)
            if (state.positions[v].w > 0) state.velocities[v].z = static_cast<float>(c.value);
    solver->upload(state);
    const int frames = std::clamp(kMostSubsteps / params.substeps, 2, kFrames);
    while (record.frames < frames) {
        solver->step({params, record.frames / double(params.frame_rate), params.substeps});
        solver->finish();
        if (solver->first_lost()) throw Error(advice_after_blow_up(model, params), ExitCode::went_bad);
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        if (!record.looks_well(model, state, params)) return;
    }
}

bool is_said_by_a_scene(Extreme extreme)
{
    switch (extreme) {
    case Extreme::mass_ratio:
    case Extreme::speed:
    case Extreme::sliver:
    case Extreme::no_area:
    case Extreme::coincident: return false;
    default: return true;
    }
}

}  // namespace

Json measure_extreme(const Scene& scene, const SimParams& params, const ExtremeCase& c)
{
    Record record;
    try {
        const SimParams extreme = params_of(scene, params, c);
        if (is_said_by_a_scene(c.extreme))
            run_scene(scene, extreme, c, record);
        else
            run_solver(scene, extreme, c, record);
    } catch (const Error& error) {
        record.outcome = error.code() == ExitCode::went_bad ? Outcome::went_bad : Outcome::refused;
        record.said = error.what();
    } catch (const std::exception& error) {
        record.outcome = Outcome::crashed;
        record.said = error.what();
    }
    return {{"what", c.what},
            {"outcome", name_of(record.outcome)},
            {"expected", c.expected()},
            {"as_expected", c.expects(record.outcome)},
            {"said", record.said},
            {"frames", record.frames},
            {"substeps", record.substeps},
            {"max_strain", record.max_strain},
            {"max_speed", record.max_speed}};
}

}  // namespace nuno
