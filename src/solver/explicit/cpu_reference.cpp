// The reference: adaptive steps in double.
#include "solver/explicit/cpu_reference.h"

#include <algorithm>
#include <cmath>

namespace nuno {
namespace {

constexpr double kFirstStep = 1e-4, kLeastStep = 1e-12;  // [s]

glm::dvec3 in_double(const glm::vec4& a) { return glm::dvec3(a.x, a.y, a.z); }

// What was downloaded and comes back unchanged keeps its digits.
bool replace(glm::dvec3& kept, const glm::vec4& given)
{
    if (glm::vec3(kept) == glm::vec3(given)) return false;
    kept = in_double(given);
    return true;
}

WideVec3 wide_of_eight(const std::vector<glm::dvec3>& a, std::size_t first)
{
    float x[kLanes], y[kLanes], z[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const glm::vec3 value(a[std::min(first + lane, a.size() - 1)]);
        x[lane] = value.x;
        y[lane] = value.y;
        z[lane] = value.z;
    }
    return {WideFloat(x), WideFloat(y), WideFloat(z)};
}

glm::vec4 lane_of(const WideVec3& a, std::size_t lane)
{
    return {a.x.lanes[lane], a.y.lanes[lane], a.z.lanes[lane], 0};
}

}  // namespace

CpuReference::CpuReference(const ClothModel& model, const Bodies& bodies, const SimParams&, ThreadPool& pool)
    : HostSolver(pool), model_(model), bodies_(bodies, model), method_(model.vertex_count())
{
    for (auto* values : {&now_.x, &now_.v, &next_.x, &next_.v}) values->resize(model.vertex_count());
    inverse_mass_.resize(model.vertex_count());
    area_.resize(model.vertex_count());
    shortest_thread_ = 1e30;
    for (const Spring& spring : model.springs)
        if (is_thread(spring.kind)) shortest_thread_ = std::min(shortest_thread_, double(spring.rest_length));
}

void CpuReference::upload(const ClothState& state)
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) {
        fresh_ = replace(now_.x[i], state.positions[i]) || fresh_;
        fresh_ = replace(now_.v[i], state.velocities[i]) || fresh_;
        inverse_mass_[i] = double(state.positions[i].w);
        area_[i] = state.velocities[i].w;
    }
    fresh_ = true;
}

void CpuReference::upload_positions(std::span<const glm::vec4> positions)
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) fresh_ = replace(now_.x[i], positions[i]) || fresh_;
}

void CpuReference::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) fresh_ = replace(now_.v[i], velocities[i]) || fresh_;
}

void CpuReference::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    now_.x[vertex] = in_double(position);
    now_.v[vertex] = glm::dvec3(0);
    inverse_mass_[vertex] = double(position.w);
    fresh_ = true;
}

void CpuReference::move_vertices(std::span<const VertexMove> moves)
{
    for (const VertexMove& move : moves) {
        now_.x[move.vertex] = glm::dvec3(move.position);
        now_.v[move.vertex] += glm::dvec3(move.velocity_gain);
    }
    fresh_ = fresh_ || !moves.empty();
}

void CpuReference::refresh(const SimParams& params)
{
    const auto* a = reinterpret_cast<const std::byte*>(&params);
    if (forces_ && std::equal(a, a + sizeof params, reinterpret_cast<const std::byte*>(&params_))) return;
    forces_.emplace(model_, params);
    params_ = params;
    fresh_ = true;
}

void CpuReference::carry(Archive& archive, const SimParams& params)
{
    refresh(params);
    for (auto* values : {&now_.x, &now_.v}) archive.values(std::span(*values));
    archive.value(step_s_);
    archive.value(fresh_);
    if (!fresh_) method_.carry(archive);
}

void CpuReference::step(const StepInput& input)
{
    refresh(input.params);
    const double end = double(input.substep_count) * double(substep_s(input.params));
    for (double time = 0; time < end;) {
        double longest = end - time;
        // Two steps of like length rather than a long one and a stub.
        if (step_s_ > 0 && longest > step_s_ && longest < 2 * step_s_) longest /= 2;
        const double taken = advance(input.params, input.start_time_s + time, longest);
        time = end - time - taken < kLeastStep ? end : time + taken;
    }
}

// One step, of at most `longest_s`; returns its length.
double CpuReference::advance(const SimParams& params, double time_s, double longest_s)
{
    const auto acceleration = [&](std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time,
                                  std::span<glm::dvec3> a) {
        forces_->forces(x, v, time, a);
        for (std::size_t i = 0; i < a.size(); ++i) a[i] *= inverse_mass_[i];
    };
    const double tolerance = params.tolerance > 0 ? double(params.tolerance) : kOwnTolerance;
    const double wanted = tolerance * kErrorShare * shortest_thread_;
    double h = std::min(step_s_ > 0 ? step_s_ : kFirstStep, longest_s);
    for (;;) {
        bodies_.plan(time_s, h, 1);
        start_pins();
        const double error =
            method_.step(acceleration, now_, time_s, h, fresh_ || !bodies_.steps().pins().empty(), next_);
        const double next = DormandPrince::next_step(h, error, wanted);
        fresh_ = false;
        if (!std::isfinite(error)) {  // no step is short enough: let it be seen at the end of the frame
            step_s_ = 0;
            h = longest_s;
            break;
        }
        if (error <= wanted || h <= kLeastStep) {
            // A step cut short by the end of a frame says little about how long one may be.
            step_s_ = h < step_s_ ? std::max(std::min(next, 5 * step_s_), std::min(step_s_, next)) : next;
            break;
        }
        h = std::max(next, kLeastStep);
        step_s_ = h;
    }
    method_.accept();
    ++step_count_;
    std::swap(now_, next_);
    meet_bodies(params);
    return h;
}

// A moving pin goes straight through a step, at the speed that brings it to its place at the end.
void CpuReference::start_pins()
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i)
        if (inverse_mass_[i] == 0) now_.v[i] = glm::dvec3(0);
    const BodySteps& steps = bodies_.steps();
    for (std::size_t k = 0; k < steps.pins().size(); ++k)
        now_.v[steps.pins()[k].vertex] = in_double(steps.pin_steps(0)[k].velocity);
}

void CpuReference::meet_bodies(const SimParams& params)
{
    const BodySteps& steps = bodies_.steps();
    for (std::size_t k = 0; k < steps.pins().size(); ++k) {
        now_.x[steps.pins()[k].vertex] = in_double(steps.pin_steps(0)[k].position);
        fresh_ = true;
    }
    if (steps.body_count() == 0) return;
    const BodyContacts contacts = bodies_.contacts(0, params);
    for (std::size_t first = 0; first < now_.x.size(); first += kLanes) {
        const formulas_wide::Motion free{wide_of_eight(now_.x, first), wide_of_eight(now_.v, first)};
        const formulas_wide::Motion held =
            push_out_of_bodies<kLanes>(contacts, wide_of_eight(next_.x, first), free).motion;
        for (std::size_t lane = 0; lane < kLanes && first + lane < now_.x.size(); ++lane) {
            if (inverse_mass_[first + lane] == 0) continue;
            fresh_ = replace(now_.x[first + lane], lane_of(held.position, lane)) || fresh_;
            fresh_ = replace(now_.v[first + lane], lane_of(held.velocity, lane)) || fresh_;
        }
    }
}

void CpuReference::download_positions(std::span<glm::vec4> positions)
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i)
        positions[i] = glm::vec4(glm::vec3(now_.x[i]), static_cast<float>(inverse_mass_[i]));
}

void CpuReference::download_velocities(std::span<glm::vec4> velocities)
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i) velocities[i] = glm::vec4(glm::vec3(now_.v[i]), area_[i]);
}

std::optional<std::uint32_t> CpuReference::first_lost()
{
    for (std::uint32_t i = 0; i < model_.vertex_count(); ++i)
        for (int k = 0; k < 3; ++k)
            if (is_lost(static_cast<float>(now_.x[i][k])) || is_lost(static_cast<float>(now_.v[i][k]))) return i;
    return std::nullopt;
}

}  // namespace nuno
