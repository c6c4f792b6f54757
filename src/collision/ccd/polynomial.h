// Polynomials of time with integer coefficients, of degree 3 at most, and their signs at binary fractions.
#pragma once

#include <array>

#include "collision/ccd/integer.h"

namespace nuno {

// c[0] + c[1] t + ..; the last coefficient in use is not 0, and 0 itself has none.
struct Polynomial
{
    int count = 0;
    std::array<Integer, 4> c;

    bool is_zero() const { return count == 0; }
    void trim()
    {
        while (count > 0 && c[count - 1].sign() == 0) --count;
    }
};

// numerator / 2^shift, in [0, 1].
struct Fraction
{
    Integer numerator;
    unsigned shift = 0;
};

Fraction fraction_of(double value);             // exact; value in [0, 1]
double rounded_down(const Fraction& fraction);  // by less than 2^-53 of the value, or to 0 from below 2^-1000
Fraction middle_of(const Fraction& a, const Fraction& b);

// The signs of p at t, and of p on all of [lo, hi] where interval arithmetic shows that it has one there.
int sign_at(const Polynomial& p, const Fraction& t);
enum class SignOver
{
    negative = -1,
    zero = 0,
    positive = 1,
    unknown,
};
SignOver sign_over(const Polynomial& p, const Fraction& lo, const Fraction& hi);

// In double: the sign of p on [t, t + 4e-15], t in [0, 1]; unknown where rounding might change it.
SignOver sign_near(const Polynomial& p, double t);

// The coefficients times the power of two that makes the greatest of them at least 1/2 and less than 1.
std::array<double, 4> rounded_coefficients(const Polynomial& p);

// A greatest common divisor over the rationals, times some integer.
Polynomial common_divisor(Polynomial a, Polynomial b);

}  // namespace nuno
