// A root's bracket, narrowed by exact signs.
#include "collision/ccd/exact_root.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nuno {
namespace {

constexpr double kNarrow = 4e-15;

double rounded_up(const Fraction& fraction) { return std::max(rounded_down(fraction) * (1 + 0x1p-52), 0x1p-1000); }

}  // namespace

ExactRoot::ExactRoot(Polynomial polynomial, Fraction lo, Fraction hi, int sign_at_lo)
    : polynomial_(std::move(polynomial)), lo_(std::move(lo)), hi_(std::move(hi)), sign_at_lo_(sign_at_lo)
{
}

void ExactRoot::split_at(const Fraction& place)
{
    const int sign = sign_at(polynomial_, place);
    if (sign == 0) {
        lo_ = hi_ = place;
        is_fraction_ = true;
    } else {
        (sign == sign_at_lo_ ? lo_ : hi_) = place;
    }
}

// Certainly between lo and hi, which the rounded ones are less than one in the last place below.
bool ExactRoot::is_inside(double time) const { return time > rounded_up(lo_) && time < rounded_down(hi_); }

// Narrows to one side of the guess, and to half_width if the guess is that good.
bool ExactRoot::split_near(double guess, double half_width)
{
    if (is_inside(guess)) split_at(fraction_of(guess));
    for (const double place : {guess - half_width, guess + half_width})
        if (!is_fraction_ && is_inside(place)) split_at(fraction_of(place));
    return is_fraction_ || width() <= 2 * half_width;
}

// Newton in double, kept within the bracket.
double ExactRoot::guess() const
{
    const std::array<double, 4> c = rounded_coefficients(polynomial_);
    double lo = rounded_down(lo_), hi = rounded_down(hi_), t = 0.5 * (lo + hi);
    for (int step = 0; step < 80; ++step) {
        const double value = ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
        const double slope = (3 * c[3] * t + 2 * c[2]) * t + c[1];
        (value * sign_at_lo_ > 0 ? lo : hi) = t;
        double next = t - value / slope;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        const double move = std::fabs(next - t);
        t = next;
        if (move < 1e-16 || t <= lo || t >= hi) break;
    }
    return t;
}

void ExactRoot::narrow()
{
    if (is_narrow_) return;
    is_narrow_ = true;
    if (is_fraction_ || width() <= kNarrow) return;
    // Many a root is a short binary fraction, at which signs need no bracket.
    const double near_root = guess(), fraction = std::ldexp(std::nearbyint(std::ldexp(near_root, 32)), -32);
    const double place = std::fabs(near_root - fraction) < 1e-14 ? fraction : near_root;
    for (const double half_width : {1e-15, 1e-12, 1e-9})
        if (split_near(place, half_width)) break;
    while (!is_fraction_ && width() > kNarrow) halve();
}

bool ExactRoot::is_below(double time) const { return rounded_up(hi_) < time; }

int ExactRoot::sign_of(const Polynomial& p)
{
    if (p.count <= 1) return p.is_zero() ? 0 : p.c[0].sign();
    narrow();
    SignOver sign = sign_near(p, lower_bound());
    if (sign != SignOver::unknown) return static_cast<int>(sign);
    if (is_fraction_) return sign_at(p, lo_);
    sign = sign_over(p, lo_, hi_);
    if (sign != SignOver::unknown) return static_cast<int>(sign);

    // The divisor divides a polynomial whose only root in the bracket is simple: it changes sign there or has none.
    const Polynomial divisor = common_divisor(polynomial_, p);
    if (divisor.count > 1 && sign_at(divisor, lo_) != sign_at(divisor, hi_)) return 0;
    while (sign == SignOver::unknown) {
        for (int i = 0; i < 8 && !is_fraction_; ++i) halve();
        if (is_fraction_) return sign_at(p, lo_);
        sign = sign_over(p, lo_, hi_);
    }
    return static_cast<int>(sign);
}

}  // namespace nuno
