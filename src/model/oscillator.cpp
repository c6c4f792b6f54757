// Stability of the explicit methods on an oscillator.
#include "model/oscillator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/formulas.h"

namespace nuno {
namespace {

namespace f = formulas_f64;

// Position, velocity, and the acceleration that verlet keeps.
using State = std::array<double, 3>;
using Matrix = std::array<State, 3>;  // columns

double acceleration(const Oscillator& o, double x, double v) { return -o.omega * o.omega * x - o.rate * v; }

glm::dvec3 along(double a) { return {a, 0, 0}; }

State euler_step(Method method, const Oscillator& o, const State& s, double h)
{
    const glm::dvec3 a = along(acceleration(o, s[0], s[1]));
    const f::Motion m = method == Method::explicit_euler ? f::explicit_euler(along(s[0]), along(s[1]), a, h)
                                                         : f::symplectic_euler(along(s[0]), along(s[1]), a, h);
    return {m.position.x, m.velocity.x, 0};
}

State verlet_step(const Oscillator& o, const State& s, double h)
{
    const f::Motion m = f::verlet_drift(along(s[0]), along(s[1]), along(s[2]), h);
    const glm::dvec3 predicted = f::verlet_kick(m.velocity, along(s[2]), h / 2);
    const glm::dvec3 a = along(acceleration(o, m.position.x, predicted.x));
    return {m.position.x, f::verlet_kick(m.velocity, a, h / 2).x, a.x};
}

State rk4_step(const Oscillator& o, const State& s, double h)
{
    const f::Motion start = f::motion(along(s[0]), along(s[1]));
    f::Motion stage = start, sum = f::motion(along(0), along(0));
    for (int number = 0; number < 4; ++number) {
        const glm::dvec3 a = along(acceleration(o, stage.position.x, stage.velocity.x));
        sum = f::rk4_add(sum, stage.velocity, a, number == 0 || number == 3 ? 1 : 2);
        stage = f::rk4_stage(start, stage.velocity, a, number < 2 ? h / 2 : h);
    }
    const f::Motion end = f::rk4_end(start, sum, h);
    return {end.position.x, end.velocity.x, 0};
}

State step(Method method, const Oscillator& o, const State& s, double h)
{
    if (method == Method::verlet) return verlet_step(o, s, h);
    return method == Method::rk4 ? rk4_step(o, s, h) : euler_step(method, o, s, h);
}

// In units in which h is 1, so that all entries are of one size.
Matrix amplification(Method method, const Oscillator& oscillator, double h)
{
    const Oscillator o{oscillator.omega * h, oscillator.rate * h};
    return {step(method, o, {1, 0, 0}, 1), step(method, o, {0, 1, 0}, 1), step(method, o, {0, 0, 1}, 1)};
}

}  // namespace

// Of z^3 - t z^2 + m z - d: with p(z) for it, p(1) >= 0, p(-1) <= 0, |d| <= 1 and |m - t d| <= 1 - d^2. Where the map
// keeps nothing of the third number, d = 0 and this is |t| <= 1 + m, m <= 1.
bool is_stable(Method method, const Oscillator& oscillator, double h)
{
    constexpr double rounding = 1e-12;
    const Matrix a = amplification(method, oscillator, h);
    const auto minor = [&](std::size_t i, std::size_t j) { return a[i][i] * a[j][j] - a[i][j] * a[j][i]; };
    const double t = a[0][0] + a[1][1] + a[2][2];
    const double m = minor(0, 1) + minor(0, 2) + minor(1, 2);
    const double d = a[0][0] * minor(1, 2) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                     a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return 1 - t + m - d >= -rounding && -1 - t - m - d <= rounding && std::abs(d) <= 1 + rounding &&
           std::abs(m - t * d) <= 1 - d * d + rounding;
}

double stable_until(Method method, const Oscillator& oscillator)
{
    // In closed form, since that of cloth is millionths of the others': |1 + h l| = 1 for l^2 + rate l + omega^2 = 0.
    if (method == Method::explicit_euler) {
        const double omega_sq = oscillator.omega * oscillator.omega;
        const double square = oscillator.rate * oscillator.rate - 4 * omega_sq;
        return square < 0 ? oscillator.rate / omega_sq : 4 / (oscillator.rate + std::sqrt(square));
    }
    // No explicit method here is stable with omega h or rate h at 6.
    constexpr int steps = 384;
    const double furthest = 6 / std::max(oscillator.omega, oscillator.rate);
    double stable = 0, unstable = furthest;
    for (int i = 1; i <= steps; ++i) {
        unstable = furthest * i / steps;
        if (!is_stable(method, oscillator, unstable)) break;
        stable = unstable;
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = (stable + unstable) / 2;
        (is_stable(method, oscillator, middle) ? stable : unstable) = middle;
    }
    return stable < 1e-5 * furthest ? 0 : stable;
}

bool is_explicit(Method method)
{
    return std::find(kExplicitMethods.begin(), kExplicitMethods.end(), method) != kExplicitMethods.end();
}

}  // namespace nuno
