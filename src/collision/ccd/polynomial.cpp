// Horner's scheme without division, and Euclid's algorithm with pseudo-remainders.
#include "collision/ccd/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collision/ccd/binary_parts.h"

namespace nuno {
namespace {

// The remainder of lead(b)^k a divided by b, for the k that keeps it integer.
Polynomial pseudo_remainder(Polynomial a, const Polynomial& b)
{
    const Integer& lead = b.c[b.count - 1];
    while (a.count >= b.count) {
        const Integer factor = std::move(a.c[a.count - 1]);
        const int offset = a.count - b.count;
        --a.count;
        for (int i = 0; i < a.count; ++i) {
            a.c[i] = a.c[i] * lead;
            if (i >= offset) a.c[i].add_product(factor, b.c[i - offset], -1);
        }
        a.trim();
    }
    return a;
}

}  // namespace

Fraction fraction_of(double value)
{
    const auto [bits, exponent] = binary_parts(value);
    if (exponent >= 0) return {Integer(bits << exponent), 0};  // 0 or 1
    return {Integer(bits), static_cast<unsigned>(-exponent)};
}

double rounded_down(const Fraction& fraction)
{
    const Integer::Rounded rounded = fraction.numerator.rounded();
    const int exponent = rounded.exponent - static_cast<int>(fraction.shift);
    return exponent < -1000 ? 0.0 : std::ldexp(rounded.mantissa, exponent);
}

Fraction middle_of(const Fraction& a, const Fraction& b)
{
    const unsigned shift = std::max(a.shift, b.shift);
    Fraction middle{a.numerator << (shift - a.shift), shift + 1};
    middle.numerator += b.numerator << (shift - b.shift);
    return middle;
}

// sign(sum of c_i n^i / 2^(s i)) = sign(sum of c_i n^i 2^(s (d - i))).
int sign_at(const Polynomial& p, const Fraction& t)
{
    if (p.is_zero()) return 0;
    if (t.numerator.sign() == 0) return p.c[0].sign();
    Integer value = p.c[p.count - 1];
    unsigned shift = 0;
    for (int i = p.count - 2; i >= 0; --i) {
        value = value * t.numerator;
        shift += t.shift;
        value += p.c[i] << shift;
    }
    return value.sign();
}

SignOver sign_over(const Polynomial& p, const Fraction& lo, const Fraction& hi)
{
    if (p.is_zero()) return SignOver::zero;
    const unsigned common = std::max(lo.shift, hi.shift);
    const Integer least = lo.numerator << (common - lo.shift), most = hi.numerator << (common - hi.shift);
    Integer below = p.c[p.count - 1], above = below;
    unsigned shift = 0;
    for (int i = p.count - 2; i >= 0; --i) {
        shift += common;
        const Integer next = p.c[i] << shift;
        below = below * (below.sign() >= 0 ? least : most);
        above = above * (above.sign() >= 0 ? most : least);
        below += next;
        above += next;
    }
    if (below.sign() > 0) return SignOver::positive;
    if (above.sign() < 0) return SignOver::negative;
    return SignOver::unknown;
}

std::array<double, 4> rounded_coefficients(const Polynomial& p)
{
    std::array<Integer::Rounded, 4> rounded{};
    int most = std::numeric_limits<int>::min();
    for (int i = 0; i < p.count; ++i) {
        rounded[i] = p.c[i].rounded();
        if (rounded[i].mantissa != 0) most = std::max(most, rounded[i].exponent);
    }
    std::array<double, 4> coefficients{};
    for (int i = 0; i < p.count; ++i)
        coefficients[i] = std::ldexp(rounded[i].mantissa, std::max(rounded[i].exponent - most, -2000));
    return coefficients;
}

// With S the sum of |c_i|: at most 2 u S from the coefficients and 6 u S from Horner's scheme, u = 2^-53, and 3 S from
// the slope times 4.2e-15 from t, together below 1.4e-14 S.
SignOver sign_near(const Polynomial& p, double t)
{
    if (p.is_zero()) return SignOver::zero;
    const std::array<double, 4> c = rounded_coefficients(p);
    const double value = ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
    const double error = 2e-14 * (std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2]) + std::fabs(c[3]));
    return value > error ? SignOver::positive : value < -error ? SignOver::negative : SignOver::unknown;
}

Polynomial common_divisor(Polynomial a, Polynomial b)
{
    while (!b.is_zero()) {
        Polynomial remainder = pseudo_remainder(std::move(a), b);
        a = std::move(b);
        b = std::move(remainder);
    }
    return a;
}

}  // namespace nuno
