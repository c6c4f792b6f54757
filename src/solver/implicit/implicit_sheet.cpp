// Newton's method on the stages of implicit methods.
#include "solver/implicit/implicit_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nuno {
namespace {

constexpr int kMostIterations = 100;      // of conjugate gradients in one solve
constexpr int kMostHalvings = 6;          // of a Newton step
constexpr float kBearable = 0.25f;        // share of a spring's length over which its direction is good
constexpr double kEnergyRounding = 1e-5;  // share of a stage's energy that its sum in float may be off

// a += b, with what the sum of two floats leaves out kept in `low` (Knuth's two-sum).
NUNO_WIDE_INLINE void add_exactly(RowLanes& a, RowLanes& low, const RowLanes& b)
{
    const RowLanes sum = a + b, part = sum - a;
    const RowLanes rest = low + ((a - (sum - part)) + (b - part));
    a = sum + rest;
    low = rest - (a - sum);
}

// to = from + s v, the velocity as it is.
NUNO_SIMD_CLONES void move_row(const SheetRows& rows, const SheetMotion& from, float s, const Field3& v,
                               SheetMotion& to, int j)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        RowVec x = row_load(from.x, place), low = row_load(from.x_low, place);
        const RowVec step = RowLanes(s) * row_load(v, place);
        add_exactly(x.x, low.x, step.x);
        add_exactly(x.y, low.y, step.y);
        add_exactly(x.z, low.z, step.z);
        row_store(to.x, place, x);
        row_store(to.x_low, place, low);
    }
}

void copy_row(const SheetRows& rows, const Field3& from, Field3& to, int j)
{
    const std::size_t place = rows.at(0, j);
    std::copy_n(&from.x[place], rows.width, &to.x[place]);
    std::copy_n(&from.y[place], rows.width, &to.y[place]);
    std::copy_n(&from.z[place], rows.width, &to.z[place]);
}

struct LoadInputs
{
    const SheetRows& rows;
    const Field &inertia, &area;
    const Field3& air;
    const StageSettings& settings;
    float tau;
};

NUNO_WIDE_INLINE RowVec outer_force(const LoadInputs& in, std::size_t place, const RowLanes& inertia)
{
    const RowLanes area = row_load(in.area, place);
    const RowVec weight{inertia * RowLanes(in.settings.gravity[0]), inertia * RowLanes(in.settings.gravity[1]),
                        inertia * RowLanes(in.settings.gravity[2]) + area * RowLanes(in.settings.wind)};
    return weight + row_load(in.air, place);
}

// mass = m / tau^2 + c / tau
NUNO_SIMD_CLONES double mass_row(const LoadInputs& in, Field& mass, int j)
{
    RowLanes load{};
    for (int i = 0; i < in.rows.width; i += kRowLanes) {
        const std::size_t place = in.rows.at(i, j);
        const RowLanes inertia = row_load(in.inertia, place), none{};
        const RowLanes rate = RowLanes(1.0f / in.tau), drag = RowLanes(in.settings.damping) * row_load(in.area, place);
        row_store(mass, place, select_positive(inertia, (inertia * rate + drag) * rate, none));
        const RowVec outer = outer_force(in, place, inertia);
        load = load + select_positive(inertia, row_dot(outer, outer) / inertia, none);
    }
    return row_sum(load) * double(in.tau) * double(in.tau);
}

// r = spring forces (in r) + loads - c v - m (v - w) / tau, 0 where held.
NUNO_SIMD_CLONES void residual_row(const LoadInputs& in, const Field3& v, const Field3& goal, Field3& r, int j)
{
    const RowLanes rate(1.0f / in.tau);
    for (int i = 0; i < in.rows.width; i += kRowLanes) {
        const std::size_t place = in.rows.at(i, j);
        const RowLanes inertia = row_load(in.inertia, place);
        const RowLanes drag = RowLanes(in.settings.damping) * row_load(in.area, place);
        const RowVec speed = row_load(v, place);
        const RowVec sum = row_load(r, place) + outer_force(in, place, inertia) - drag * speed -
                           (inertia * rate) * (speed - row_load(goal, place));
        row_store(r, place, select_positive(inertia, sum, RowVec{}));
    }
}

// 1/2 m |v - w|^2 + 1/2 tau c |v|^2 - loads . (share d)
NUNO_SIMD_CLONES double energy_row(const LoadInputs& in, const Field3& v, const Field3& goal, float share,
                                   const Field3& d, int j)
{
    RowLanes energy{};
    for (int i = 0; i < in.rows.width; i += kRowLanes) {
        const std::size_t place = in.rows.at(i, j);
        const RowLanes inertia = row_load(in.inertia, place), half = RowLanes(0.5f), none{};
        const RowLanes drag = RowLanes(in.tau * in.settings.damping) * row_load(in.area, place);
        const RowVec speed = row_load(v, place), change = speed - row_load(goal, place);
        const RowLanes sum = half * (inertia * row_dot(change, change) + drag * row_dot(speed, speed)) -
                             RowLanes(share) * row_dot(outer_force(in, place, inertia), row_load(d, place));
        energy = energy + select_positive(inertia, sum, none);
    }
    return row_sum(energy);
}

}  // namespace

ImplicitSheet::ImplicitSheet(std::unique_ptr<SheetSystem> system) : system_(std::move(system)), solver_(system_->rows())
{
    const std::size_t size = system_->rows().size();
    for (SheetMotion* motion : {&now_, &at_, &trial_}) *motion = SheetMotion(size);
    for (Field3* field : {&goal_, &guess_, &zero_, &air_, &r_, &d_, &tried_}) *field = Field3(size);
    for (Field* field : {&inertia_, &area_, &mass_}) *field = Field(size);
    row_energy_.resize(std::size_t(system_->rows().rows));
    row_sums_.resize(row_energy_.size());
}

void ImplicitSheet::set_load(float tau, const StageSettings& settings, const Team& team)
{
    const SheetRows& rows = system_->rows();
    const LoadInputs in{rows, inertia_, area_, air_, settings, tau};
    for_rows(rows, team, [&](int j) { row_sums_[std::size_t(j)] = mass_row(in, mass_, j); });
    const double load = team.sum(row_sums_);
    if (team.leads()) load_sq_ = load;
    team.wait();
}

void ImplicitSheet::solve_stage(float tau, const StageSettings& settings, const Team& team)
{
    set_load(tau, settings, team);
    SolveLimits limits{settings.tolerance * load_sq_, settings.tolerance, kMostIterations};
    for (int step = 0; step < settings.newton_steps; ++step) {
        const SolveResult solved = newton_step(tau, settings, step == 0 ? &guess_ : nullptr, limits, team);
        limits = {solved.target_sq, 0, kMostIterations};
        if (solved.iterations == 0 && step > 0) break;
    }
}

// Where the tangent leads to no step that would not make energy, as about springs shorter than the way of a step, those
// which it moves too far are majorised; where that is not enough, all.
SolveResult ImplicitSheet::newton_step(float tau, const StageSettings& settings, const Field3* guess,
                                       const SolveLimits& limits, const Team& team)
{
    StageTerms terms{.tau = tau, .stiffness_damping = settings.stiffness_damping};
    const double before = linearise(terms, settings, team), rounding = kEnergyRounding * std::abs(before);
    SolveResult solved = solver_.solve(*system_, r_, guess, d_, limits, team);
    bool falls = take_step(terms, settings, before + rounding + solved.target_sq, team);
    if (team.leads()) count(solved);
    for (const float bearable : {kBearable, 0.0f}) {
        if (falls) break;
        for_rows(system_->rows(), team, [&](int j) { copy_row(system_->rows(), d_, tried_, j); });
        team.wait();
        terms.tried = &tried_;
        terms.bearable = bearable;
        linearise(terms, settings, team);
        solved = solver_.solve(*system_, r_, nullptr, d_, limits, team);
        falls = take_step(terms, settings, before + rounding, team);
        if (team.leads()) count(solved);
    }
    team.wait();
    return solved;
}

// r_ and the system's matrix at at_; the energy of the stage there.
double ImplicitSheet::linearise(const StageTerms& terms, const StageSettings& settings, const Team& team)
{
    const SheetRows& rows = system_->rows();
    const LoadInputs in{rows, inertia_, area_, air_, settings, terms.tau};
    system_->assemble(at_, mass_, terms, r_, row_energy_, team);
    for_rows(rows, team, [&](int j) {
        row_energy_[std::size_t(j)] += energy_row(in, at_.v, goal_, 0, at_.v, j);
        residual_row(in, at_.v, goal_, r_, j);
    });
    return team.sum(row_energy_);
}

// at_ += share d_, the share halved until the energy of the stage is `most`; false, and at_ as it was, where it is not.
bool ImplicitSheet::take_step(const StageTerms& terms, const StageSettings& settings, double most, const Team& team)
{
    float share = 1;
    bool falls = energy_of_step(terms, settings, share, team) <= most;
    for (int halvings = 0; !falls && halvings < kMostHalvings; ++halvings) {
        share *= 0.5f;
        team.wait();
        falls = energy_of_step(terms, settings, share, team) <= most;
    }
    team.wait();
    if (falls && team.leads()) std::swap(at_, trial_);
    team.wait();
    return falls;
}

// trial_ = at_ + share d_, and its energy.
double ImplicitSheet::energy_of_step(const StageTerms& terms, const StageSettings& settings, float share,
                                     const Team& team)
{
    const SheetRows& rows = system_->rows();
    const LoadInputs in{rows, inertia_, area_, air_, settings, terms.tau};
    const auto move = [&](int j) {
        move_row(rows, at_, share, d_, trial_, j);
        add_scaled(rows, at_.v, share / terms.tau, d_, trial_.v, j);
    };
    for_rows_in_turn(rows, system_->reach(), team, move, [&](int j) {
        row_energy_[std::size_t(j)] =
            system_->step_energy(at_, trial_, terms, j) + energy_row(in, trial_.v, goal_, share, d_, j);
    });
    return team.sum(row_energy_);
}

void ImplicitSheet::count(const SolveResult& solved)
{
    ++counts_.solves;
    counts_.iterations += solved.iterations;
    counts_.capped += solved.iterations == kMostIterations;
}

// The stage begins where the sheet is, the springs' directions with it: from where its velocity would carry it, waves
// as short as the cells would stretch the springs by far more than they can be linearised over. The velocity goes into
// the first guess of the displacement instead.
void ImplicitSheet::backward_euler(float h, const StageSettings& settings, const Team& team)
{
    start_first_stage(h, team);
    solve_stage(h, settings, team);
    if (team.leads()) std::swap(now_, at_);
    team.wait();
}

void ImplicitSheet::start_first_stage(float tau, const Team& team)
{
    const SheetRows& rows = system_->rows();
    for_rows(rows, team, [&](int j) {
        copy_row(rows, now_.x, at_.x, j);
        copy_row(rows, now_.x_low, at_.x_low, j);
        copy_row(rows, zero_, at_.v, j);
        copy_row(rows, now_.v, goal_, j);
        scale(rows, tau, now_.v, guess_, j);
    });
    team.wait();
}

// Stage 1: x1 = x0 + gamma h v1, m (v1 - v0) / (gamma h) = f1. Stage 2: x2 = x_bar + gamma h v2 with
// x_bar = x0 + (1 - gamma) h v1, and m (v2 - w) / (gamma h) = f2 with w = v0 + (1 - gamma) / gamma (v1 - v0); it begins
// at x1, which is x_bar + (2 gamma - 1) h v1, with the guess that v2 is v1.
void ImplicitSheet::sdirk2(float h, const StageSettings& first, const StageSettings& second, const Team& team)
{
    const SheetRows& rows = system_->rows();
    const double gamma = 1 - std::sqrt(0.5);
    const auto tau = static_cast<float>(gamma * double(h)), rest = static_cast<float>((1 - gamma) * double(h));
    const auto ratio = static_cast<float>((1 - gamma) / gamma), back = static_cast<float>((2 * gamma - 1) / gamma);
    start_first_stage(tau, team);
    solve_stage(tau, first, team);
    add_scaled(rows, now_.v, -ratio, now_.v, goal_, team);
    add_scaled(rows, goal_, ratio, at_.v, goal_, team);
    for_rows(rows, team, [&](int j) {
        scale(rows, rest, at_.v, guess_, j);
        scale(rows, back, at_.v, at_.v, j);
    });
    team.wait();
    solve_stage(tau, second, team);
    if (team.leads()) std::swap(now_, at_);
    team.wait();
}

}  // namespace nuno
