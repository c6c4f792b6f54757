// Implicit methods on CPU threads.
#include "solver/implicit/cpu_implicit.h"

#include <cmath>

#include "solver/implicit/grid_sheet.h"
#include "solver/implicit/mesh_system.h"

namespace nuno {
namespace {

// Newton steps a stage where the parameters leave it open: one is enough to be stable, two keep the second order where
// stiff cloth turns.
constexpr int kEulerNewtonSteps = 1, kSdirkNewtonSteps = 2;

constexpr int kLeastVerticesForThreads = 4096;

// Positions of 16 lanes in the order of the shared formulas.
NUNO_WIDE_INLINE WideVec<kRowLanes> wide_of_row(const Field3& a, std::size_t place)
{
    return {Wide<kRowLanes>(a.x.get() + place), Wide<kRowLanes>(a.y.get() + place), Wide<kRowLanes>(a.z.get() + place)};
}

NUNO_SIMD_CLONES void meet_bodies_in_row(const BodyContacts& contacts, const SheetRows& rows, const Field& inertia,
                                         const SheetMotion& before, SheetMotion& now, int j)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const WideFormulas<kRowLanes>::Motion free{wide_of_row(now.x, place), wide_of_row(now.v, place)};
        const auto held = push_out_of_bodies<kRowLanes>(contacts, wide_of_row(before.x, place), free).motion;
        const Wide<kRowLanes> mass(inertia.get() + place);
        for (int lane = 0; lane < kRowLanes; ++lane) {
            const std::size_t at = place + std::size_t(lane);
            const bool moved = held.position.x.lanes[lane] != now.x.x[at] ||
                               held.position.y.lanes[lane] != now.x.y[at] || held.position.z.lanes[lane] != now.x.z[at];
            if (!(mass.lanes[lane] > 0)) continue;
            now.v.x[at] = held.velocity.x.lanes[lane];
            now.v.y[at] = held.velocity.y.lanes[lane];
            now.v.z[at] = held.velocity.z.lanes[lane];
            if (!moved) continue;
            now.x.x[at] = held.position.x.lanes[lane];
            now.x.y[at] = held.position.y.lanes[lane];
            now.x.z[at] = held.position.z.lanes[lane];
            now.x_low.x[at] = now.x_low.y[at] = now.x_low.z[at] = 0;
        }
    }
}

// What comes back as it was downloaded keeps its digits.
void put_position(SheetMotion& motion, std::size_t at, const glm::vec4& x)
{
    if (motion.x.x[at] == x.x && motion.x.y[at] == x.y && motion.x.z[at] == x.z) return;
    motion.x.x[at] = x.x;
    motion.x.y[at] = x.y;
    motion.x.z[at] = x.z;
    motion.x_low.x[at] = motion.x_low.y[at] = motion.x_low.z[at] = 0;
}

void put_velocity(SheetMotion& motion, std::size_t at, const glm::vec4& v)
{
    motion.v.x[at] = v.x;
    motion.v.y[at] = v.y;
    motion.v.z[at] = v.z;
}

}  // namespace

CpuImplicit::CpuImplicit(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool)
    : model_(model),
      method_(params.method),
      pool_(pool),
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
    put_position(p.sheet->motion(), p.at, position);
    inverse_mass_[vertex] = position.w;
    p.sheet->inertia()[p.at] = position.w > 0 ? 1 / position.w : 0.0f;
}

// What is held does not move but by its handle.
void CpuImplicit::set_velocity(std::uint32_t vertex, const glm::vec4& velocity)
{
    const Place& p = places_[vertex];
    put_velocity(p.sheet->motion(), p.at, inverse_mass_[vertex] > 0 ? velocity : glm::vec4(0));
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

void CpuImplicit::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) set_velocity(v, velocities[v]);
}

void CpuImplicit::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    place_vertex(vertex, position);
    set_velocity(vertex, glm::vec4(0));
}

void CpuImplicit::refresh(const SimParams& params)
{
    if (face_forces(params).air != (air_ != nullptr)) {
        air_ = air_ ? nullptr : std::make_unique<Air>(model_);
        for (const Place& p : places_) p.sheet->air().x[p.at] = p.sheet->air().y[p.at] = p.sheet->air().z[p.at] = 0;
    }
    if (springs_of_ && !spring_weights_differ(*springs_of_, params)) return;
    const std::vector<SpringWeight> weights = spring_weights(model_, params);
    for (const auto& sheet : sheets_) sheet->system().set_springs(model_, weights);
    springs_of_ = params;
}

StageSettings CpuImplicit::settings(const SimParams& params, double time_s) const
{
    const int own = method_ == Method::implicit_euler ? kEulerNewtonSteps : kSdirkNewtonSteps;
    return {{params.gravity_x, params.gravity_y, params.gravity_z},
            wind_pressure(params, time_s),
            params.damping,
            params.areal_density,
            params.stiffness_damping,
            double(params.tolerance),
            params.iterations > 0 ? params.iterations : own};
}

void CpuImplicit::step(const StepInput& input)
{
    refresh(input.params);
    bodies_.plan(input);
    const int thread_count = model_.vertex_count() < kLeastVerticesForThreads ? 1 : pool_.thread_count();
    const auto run = [&](const Team& team) {
        for (int k = 0; k < input.substep_count; ++k) {
            if (team.leads()) start_pins(k);
            team.wait();
            blow(input.params, input.start_time_s + k * double(substep_s(input.params)), team);
            for (const auto& sheet : sheets_) step_sheet(*sheet, input, k, team);
            team.wait();
            if (team.leads()) end_pins(k);
            team.wait();
        }
    };
    if (thread_count == 1) return run(Team(0, 1, nullptr));
    SpinBarrier barrier(thread_count);
    pool_.run([&](int thread) { run(Team(thread, thread_count, &barrier)); });
}

// The force of moving air at the start of a substep, which holds through it (shaders/shared/aero.h bounds it so that it
// does not turn the motion round).
void CpuImplicit::blow(const SimParams& params, double time_s, const Team& team)
{
    if (!air_) return;
    FaceInputs in{face_forces(params), {}, air_of(params), air_field(params, time_s), air_->x.lanes(), air_->v.lanes()};
    in.wanted.membrane = false;
    const Range blocks = team.part(air_->faces.block_count());
    const auto begin = static_cast<std::uint32_t>(blocks.begin * kLanes);
    const std::uint32_t end = std::min(static_cast<std::uint32_t>(blocks.end * kLanes), model_.vertex_count());
    for (std::uint32_t i = begin; i < end; ++i) {
        const SheetMotion& m = places_[i].sheet->motion();
        const std::size_t at = places_[i].at;
        air_->x.put(i, {m.x.x[at], m.x.y[at], m.x.z[at], 0});
        air_->v.put(i, {m.v.x[at], m.v.y[at], m.v.z[at], 0});
    }
    team.wait();
    air_->faces.run(in, blocks);
    team.wait();
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const WideVec3 force = air_->faces.force_on_block(block);
        for (std::uint32_t lane = 0; lane < kLanes && std::uint32_t(block * kLanes) + lane < end; ++lane) {
            const Place& p = places_[std::uint32_t(block * kLanes) + lane];
            p.sheet->air().x[p.at] = force.x.lanes[lane];
            p.sheet->air().y[p.at] = force.y.lanes[lane];
            p.sheet->air().z[p.at] = force.z.lanes[lane];
        }
    }
    team.wait();
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
    const Range part = team.part(rows.rows);
    for (int j = part.begin; j < part.end; ++j)
        meet_bodies_in_row(contacts, rows, sheet.inertia(), sheet.motion_before(), sheet.motion(), j);
    team.wait();
}

// A moving pin goes straight through the substep, at the speed that brings it to its place at the end.
void CpuImplicit::start_pins(int substep)
{
    const std::span<const PinStep> steps = bodies_.steps().pin_steps(substep);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Place& p = places_[bodies_.steps().pins()[k].vertex];
        put_velocity(p.sheet->motion(), p.at, steps[k].velocity);
    }
}

void CpuImplicit::end_pins(int substep)
{
    const std::span<const PinStep> steps = bodies_.steps().pin_steps(substep);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Place& p = places_[bodies_.steps().pins()[k].vertex];
        put_position(p.sheet->motion(), p.at, steps[k].position);
        put_velocity(p.sheet->motion(), p.at, steps[k].velocity);
    }
}

void CpuImplicit::download_positions(std::span<glm::vec4> positions)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) {
        const SheetMotion& m = places_[v].sheet->motion();
        const std::size_t at = places_[v].at;
        positions[v] = {m.x.x[at], m.x.y[at], m.x.z[at], inverse_mass_[v]};
    }
}

void CpuImplicit::download_velocities(std::span<glm::vec4> velocities)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) {
        const SheetMotion& m = places_[v].sheet->motion();
        const std::size_t at = places_[v].at;
        velocities[v] = {m.v.x[at], m.v.y[at], m.v.z[at], area_[v]};
    }
}

std::optional<std::uint32_t> CpuImplicit::first_not_finite()
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) {
        const SheetMotion& m = places_[v].sheet->motion();
        const std::size_t at = places_[v].at;
        for (const float a : {m.x.x[at], m.x.y[at], m.x.z[at], m.v.x[at], m.v.y[at], m.v.z[at]})
            if (!std::isfinite(a)) return v;
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
        sum.most_iterations = std::max(sum.most_iterations, c.most_iterations);
        sum.capped += c.capped;
        sum.shortened += c.shortened;
    }
    return sum;
}

}  // namespace nuno
