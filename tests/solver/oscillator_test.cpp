// One mass on one spring, a = -omega^2 x: the period and amplitude of every method, and energy over a thousand periods
// (Hairer, Lubich and Wanner, Geometric Numerical Integration, I.1 and IX; Hairer and Wanner, Solving ODEs II, IV.3).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

using Complex = std::complex<double>;

// A substep multiplies x + i v / omega by R(i W), W = omega h, up to a constant change of coordinates:
//     explicit Euler 1 + z;  implicit Euler, which vbd descends to, 1 / (1 - z);  Runge's 1 + z + z^2/2 + z^3/6 +
//     z^4/24; symplectic Euler and Verlet exp(2 i asin(W / 2));  BDF2, which xpbd predicts with, (2 + sqrt(1 + 2 z)) /
//     (3 - 2 z); Alexander's (1 + (1 - 2 g) z) / (1 - g z)^2, g = 1 - 1 / sqrt(2);  the exact motion, exp(z).
Complex multiplier(Method method, double w)
{
    const Complex z(0, w);
    const double g = 1 - std::sqrt(0.5);
    switch (method) {
    case Method::explicit_euler: return 1.0 + z;
    case Method::symplectic_euler:
    case Method::verlet: return std::polar(1.0, 2 * std::asin(w / 2));
    case Method::rk4: return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    case Method::xpbd: return (2.0 + std::sqrt(1.0 + 2.0 * z)) / (3.0 - 2.0 * z);
    case Method::vbd:
    case Method::implicit_euler: return 1.0 / (1.0 - z);
    case Method::sdirk2: return (1.0 + (1 - 2 * g) * z) / ((1.0 - g * z) * (1.0 - g * z));
    default: return std::exp(z);
    }
}

constexpr double kMass = 0.2;  // 1 m2 of the default density

// h is 1 / substeps.
SimParams oscillator_params(const MethodAndSweep& each, double omega, int substeps)
{
    SimParams params = on_cpu(each.method, each.sweep);
    params.gravity_y = params.damping = 0;
    params.structural_stiffness = static_cast<float>(kMass * omega * omega);
    params.substeps = substeps;
    params.tolerance = 1e-8f;
    return params;
}

// Place and speed of the mass, one a substep, from rest at 1 + amplitude.
struct Track
{
    std::vector<double> x, v;
};

Track track(const SimParams& params, double amplitude, int substeps)
{
    const ClothModel model = one_spring();
    ThreadPool pool(1);
    const auto solver = make_solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    state.positions[1].x = static_cast<float>(1 + amplitude);
    solver->upload(state);
    Track found;
    for (int step = 0; step < substeps; ++step) {
        solver->step({params, step * double(substep_s(params)), 1});
        state = state_of(*solver, model);
        found.x.push_back(double(state.positions[1].x) - 1);
        found.v.push_back(double(state.velocities[1].x));
    }
    return found;
}

// The root of x[n+1] = 2 Re(r) x[n] - |r|^2 x[n-1] that fits all of x from `first` on best.
Complex fitted_multiplier(const std::vector<double>& x, std::size_t first)
{
    double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;
    for (std::size_t n = first + 1; n + 1 < x.size(); ++n) {
        aa += x[n] * x[n], ab -= x[n] * x[n - 1], bb += x[n - 1] * x[n - 1];
        ay += x[n] * x[n + 1], by -= x[n - 1] * x[n + 1];
    }
    const double twice_real = (ay * bb - by * ab) / (aa * bb - ab * ab);
    const double size_sq = (aa * by - ab * ay) / (aa * bb - ab * ab);
    return {twice_real / 2, std::sqrt(size_sq - twice_real * twice_real / 4)};
}

class OscillatorTest : public testing::TestWithParam<MethodAndSweep>
{};

// Positions near 1 round to 6e-8, a share of 1e-7 of an amplitude of 0.5; the angle is W / that apart.
TEST_P(OscillatorTest, period_and_amplitude_of_a_substep_are_those_of_the_method)
{
    const bool grows = GetParam().method == Method::explicit_euler;
    for (const double w : {0.3, 1.0}) {
        if (grows && w > 0.3) continue;
        const Track found = track(oscillator_params(GetParam(), 100 * w, 100), grows ? 0.01 : 0.5, 60);
        // BDF2 has another root, near 1 / 3, which is gone after 15 substeps.
        const Complex measured = fitted_multiplier(found.x, GetParam().method == Method::xpbd ? 15 : 0),
                      expected = multiplier(GetParam().method, w);
        const double tolerance = grows ? 1e-4 : 1e-5;
        expect_measured(fmt::format("oscillator, {}, omega h {}: amplitude after a substep", name_of(GetParam()), w),
                        std::abs(measured), std::abs(expected), tolerance);
        expect_measured(fmt::format("oscillator, {}, omega h {}: period over the true one", name_of(GetParam()), w),
                        w / std::arg(measured), w / std::arg(expected), tolerance / w);
    }
}

// Rows need a grid, which a spring by itself is not.
std::vector<MethodAndSweep> methods_without_rows()
{
    std::vector<MethodAndSweep> all = methods_and_sweeps();
    std::erase_if(all, [](const MethodAndSweep& each) { return each.sweep == Sweep::rows; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Methods, OscillatorTest, testing::ValuesIn(methods_without_rows()), kMethodName);

// Least and most energy in the last 20 of 1000 periods over that at the start, and the mean period.
struct LongRun
{
    double least, most, period_s;
};

LongRun thousand_periods(Method method, int substeps_a_period)
{
    const double omega = 2 * M_PI * 10;  // ten periods a second
    const SimParams params = oscillator_params({method}, omega, 10 * substeps_a_period);
    const double amplitude = 0.5, start = std::pow(amplitude * omega, 2);
    const Track found = track(params, amplitude, 1000 * substeps_a_period);
    LongRun run{1e9, 0, 0};
    for (std::size_t n = found.x.size() - std::size_t(20 * substeps_a_period); n < found.x.size(); ++n) {
        const double energy = (std::pow(found.x[n] * omega, 2) + std::pow(found.v[n], 2)) / start;
        run.least = std::min(run.least, energy);
        run.most = std::max(run.most, energy);
    }
    double first = 0, last = 0;
    int crossings = 0;
    for (std::size_t n = 1; n < found.x.size(); ++n) {
        if ((found.x[n - 1] < 0) == (found.x[n] < 0)) continue;
        last = double(n) - found.x[n] / (found.x[n] - found.x[n - 1]);
        if (crossings++ == 0) first = last;
    }
    run.period_s = 2 * (last - first) / (crossings - 1) * double(substep_s(params));
    return run;
}

// Symplectic Euler keeps v^2 + omega^2 x^2 -+ h omega^2 x v, so its energy stays in [1 / (1 + W/2), 1 / (1 - W/2)] of
// that at the start; Verlet keeps v^2 + omega^2 x^2 (1 - W^2/4), so in [1 - W^2/4, 1]; Runge loses W^6/72 - W^8/576 a
// substep. Each period is 2 pi h / arg R. 50000 substeps round by 6e-8 of 0.5 each: 6e-3 if all were one way, 3e-5 by
// chance.
TEST(Energy, over_a_thousand_periods_stays_or_falls_as_theory_says)
{
    for (const Method method : {Method::symplectic_euler, Method::verlet, Method::rk4})
        for (const int substeps : {20, 50}) {
            const double w = 2 * M_PI / substeps, lost = std::norm(multiplier(Method::rk4, w));
            double least = 1 / (1 + w / 2), most = 1 / (1 - w / 2);
            if (method == Method::verlet) least = 1 - w * w / 4, most = 1;
            if (method == Method::rk4) least = std::pow(lost, 1000 * substeps), most = std::pow(lost, 980 * substeps);
            const LongRun run = thousand_periods(method, substeps);
            const auto what = [&](const char* number) {
                return fmt::format("1000 periods of {} substeps, {}: {}", substeps, name_of(method), number);
            };
            expect_measured(what("least energy at the end over the start"), run.least, least, 1e-3);
            expect_measured(what("most energy at the end over the start"), run.most, most, 1e-3);
            const double period = 0.1 * w / std::arg(multiplier(method, w));
            expect_measured(what("period, s"), run.period_s, period, 1e-5 * period);
        }
}

}  // namespace
}  // namespace nuno
