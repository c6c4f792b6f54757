// Implicit methods on CPU threads.
#include "solver/implicit/cpu_implicit.h"

#include <algorithm>
#include <cmath>

#include "solver/implicit/grid_sheet.h"
#include "solver/implicit/mesh_system.h"

namespace nuno {
namespace {

// Newton steps a stage where the parameters leave it open: one is enough to be stable, two keep the second order where
// stiff cloth turns.
constexpr int kEulerNewtonSteps = 1, kSdirkNewtonSteps = 2;

// The tolerance where the parameters leave it open: strains of a hanging sheet are within 5 % of those of exact solves
// in the last half of 2 s (bench/implicit_bench, accuracy), and a solve takes one cycle or two at any size.
constexpr double kOwnTolerance = 0.1;

// What comes back as it was keeps its digits.
void put_position(SheetMotion& motion, std::size_t place, const glm::vec3& x)
{
    if (at(motion.x, place) == x) return;
    put(motion.x, place, x);
    put(motion.x_low, place, glm::vec3(0));
}

NUNO_SIMD_CLONES void meet_bodies_in_row(const BodyContacts& contacts, const SheetRows& rows, const Field& inertia,
                                         const SheetMotion& before, SheetMotion& now, int j)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const WideFormulas<kRowLanes>::Motion free{row_load(now.x, place), row_load(now.v, place)};
        const auto held = push_out_of_bodies<kRowLanes>(contacts, row_load(before.x, place), free).motion;
        const RowLanes mass = row_load(inertia, place);
        for (int lane = 0; lane < kRowLanes; ++lane) {
            if (!(mass.lanes[lane] > 0)) continue;
            const std::size_t i_lane = place + std::size_t(lane);
            const auto of_lane = [&](const RowVec& a) {
                return glm::vec3(a.x.lanes[lane], a.y.lanes[lane], a.z.lanes[lane]);
            };
            put(now.v, i_lane, of_lane(held.velocity));
            put_position(now, i_lane, of_lane(held.position));
        }
    }
}

}  // namespace

CpuImplicit::CpuImplicit(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool)
    : HostSolver(pool),
      model_(model),
      method_(params.method),
      bodies_(bodies, model),
      places_(model.vertex_count()),
      inverse_mass_(model.vertex_count()),
      area_(model.vertex_count())
{
    for (const Sheet& sheet : model.sheets) {
        std::unique_ptr<SheetSystem> system;
        if (sheet.is_grid())
            system = std::make_unique<GridSheet>(sheet);
        else
            system = std::make_unique<MeshSystem>(model, sheet);
        sheets_.push_back(std::make_unique<ImplicitSheet>(std::move(system)));
        for (std::uint32_t v = sheet.first_vertex; v < sheet.first_vertex + sheet.vertex_count; ++v)
            places_[v] = {sheets_.back().get(), sheets_.back()->system().place(v)};
    }
}

std::string_view CpuImplicit::name() const
{
    return method_ == Method::implicit_euler ? "implicit_euler on cpu" : "sdirk2 on cpu";
}

void CpuImplicit::place_vertex(std::uint32_t vertex, const glm::vec4& position)
{
    const Place& p = places_[vertex];
    put_position(p.sheet->motion(), p.at, glm::vec3(position));
    inverse_mass_[vertex] = position.w;
    p.sheet->inertia()[p.at] = position.w > 0 ? 1 / position.w : 0.0f;
}

// What is held does not move but by its handle.
void CpuImplicit::set_velocity(std::uint32_t vertex, const glm::vec4& velocity)
{
    const Place& p = places_[vertex];
    put(p.sheet->motion().v, p.at, inverse_mass_[vertex] > 0 ? glm::vec3(velocity) : glm::vec3(0));
}

void CpuImplicit::upload(const ClothState& state)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) {
        place_vertex(v, state.positions[v]);
        set_velocity(v, state.velocities[v]);
        area_[v] = state.velocities[v].w;
        places_[v].sheet->area()[places_[v].at] = area_[v];
    }
}

void CpuImplicit::upload_positions(std::span<const glm::vec4> positions)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v)
        put_position(places_[v].sheet->motion(), places_[v].at, glm::vec3(positions[v]));
}

void CpuImplicit::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) set_velocity(v, velocities[v]);
}

void CpuImplicit::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    place_vertex(vertex, position);
    set_velocity(vertex, glm::vec4(0));
}

void CpuImplicit::move_vertices(std::span<const VertexMove> moves)
{
    for (const VertexMove& move : moves) {
        const Place& p = places_[move.vertex];
        put_position(p.sheet->motion(), p.at, move.position);
        put(p.sheet->motion().v, p.at, at(p.sheet->motion().v, p.at) + move.velocity_gain);
    }
}

void CpuImplicit::refresh(const SimParams& params)
{
    if (face_forces(params).air != air_.has_value()) {
        if (air_)
            air_.reset();
        else
            air_.emplace(model_);
        for (const Place& p : places_) put(p.sheet->air(), p.at, glm::vec3(0));
    }
    if (springs_of_ && !spring_weights_differ(*springs_of_, params)) return;
    const std::vector<SpringWeight> weights = spring_weights(model_, params);
    for (const auto& sheet : sheets_) sheet->system().set_springs(model_, weights);
    springs_of_ = params;
}

StageSettings CpuImplicit::settings(const SimParams& params, double time_s) const
{
    const int own = method_ == Method::implicit_euler ? kEulerNewtonSteps : kSdirkNewtonSteps;
    return {.gravity = {params.gravity_x, params.gravity_y, params.gravity_z},
            .wind = wind_pressure(params, time_s),
            .damping = params.damping,
            .stiffness_damping = params.stiffness_damping,
            .tolerance = params.tolerance > 0 ? double(params.tolerance) : kOwnTolerance,
            .newton_steps = params.iterations > 0 ? params.iterations : own};
}

void CpuImplicit::carry(Archive& archive, const SimParams&)
{
    std::vector<glm::vec3> low(places_.size());
    for (std::size_t v = 0; v < low.size(); ++v) low[v] = at(places_[v].sheet->motion().x_low, places_[v].at);
    archive.values(std::span(low));
    for (std::size_t v = 0; v < low.size(); ++v) put(places_[v].sheet->motion().x_low, places_[v].at, low[v]);
}

void CpuImplicit::step(const StepInput& input)
{
    refresh(input.params);
    bodies_.plan(input);
    run_team(pool_, team_size(pool_, model_.vertex_count()), [&](const Team& team) {
        for (int k = 0; k < input.substep_count; ++k) {
            if (team.leads()) start_pins(k);
            team.wait();
            blow(input.params, input.start_time_s + k * double(substep_s(input.params)), team);
            for (const auto& sheet : sheets_) step_sheet(*sheet, input, k, team);
            team.wait();
            if (team.leads()) end_pins(k);
            team.wait();
        }
    });
}

// The force of moving air at the start of a substep, which holds through it (shaders/shared/aero.h bounds it so that it
// does not turn the motion round).
void CpuImplicit::blow(const SimParams& params, double time_s, const Team& team)
{
    if (!air_) return;
    const auto motion_of = [&](std::uint32_t vertex) {
        const Place& p = places_[vertex];
        return formulas::motion(at(p.sheet->motion().x, p.at), at(p.sheet->motion().v, p.at));
    };
    const auto take = [&](std::uint32_t vertex, glm::vec3 force) {
        put(places_[vertex].sheet->air(), places_[vertex].at, force);
    };
    air_->run(params, time_s, team, motion_of, take);
}

void CpuImplicit::step_sheet(ImplicitSheet& sheet, const StepInput& input, int substep, const Team& team)
{
    const double h = double(substep_s(input.params)), time_s = input.start_time_s + substep * h;
    const double first_stage = 1 - std::sqrt(0.5);
    if (method_ == Method::implicit_euler)
        sheet.backward_euler(float(h), settings(input.params, time_s + h), team);
    else
        sheet.sdirk2(float(h), settings(input.params, time_s + first_stage * h), settings(input.params, time_s + h),
                     team);
    const BodyContacts contacts = bodies_.contacts(substep, input.params);
    if (contacts.bodies.empty()) return;
    const SheetRows& rows = sheet.system().rows();
    for_rows(rows, team, [&](int j) {
        meet_bodies_in_row(contacts, rows, sheet.inertia(), sheet.motion_before(), sheet.motion(), j);
    });
    team.wait();
}

// A moving pin goes straight through the substep, at the speed that brings it to its place at the end.
void CpuImplicit::start_pins(int substep)
{
    const std::span<const PinStep> steps = bodies_.steps().pin_steps(substep);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Place& p = places_[bodies_.steps().pins()[k].vertex];
        put(p.sheet->motion().v, p.at, glm::vec3(steps[k].velocity));
    }
}

void CpuImplicit::end_pins(int substep)
{
    const std::span<const PinStep> steps = bodies_.steps().pin_steps(substep);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Place& p = places_[bodies_.steps().pins()[k].vertex];
        put_position(p.sheet->motion(), p.at, glm::vec3(steps[k].position));
        put(p.sheet->motion().v, p.at, glm::vec3(steps[k].velocity));
    }
}

void CpuImplicit::download_positions(std::span<glm::vec4> positions)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v)
        positions[v] = glm::vec4(at(places_[v].sheet->motion().x, places_[v].at), inverse_mass_[v]);
}

void CpuImplicit::download_velocities(std::span<glm::vec4> velocities)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v)
        velocities[v] = glm::vec4(at(places_[v].sheet->motion().v, places_[v].at), area_[v]);
}

std::optional<std::uint32_t> CpuImplicit::first_lost()
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) {
        const SheetMotion& m = places_[v].sheet->motion();
        const glm::vec3 x = at(m.x, places_[v].at), u = at(m.v, places_[v].at);
        for (const float a : {x.x, x.y, x.z, u.x, u.y, u.z})
            if (is_lost(a)) return v;
    }
    return std::nullopt;
}

SolveCounts CpuImplicit::counts() const
{
    SolveCounts sum;
    for (const auto& sheet : sheets_) {
        const SolveCounts& c = sheet->counts();
        sum.solves += c.solves;
        sum.iterations += c.iterations;
        sum.capped += c.capped;
    }
    return sum;
}

}  // namespace nuno
