// Polynomials with rational coefficients and their real roots, by Sturm's theorem: slow, and short enough to believe.
#pragma once

#include <vector>

#include <gmpxx.h>

namespace nuno {

using Rational = mpq_class;

// Constant term first, no 0 at the end; empty is 0.
struct RationalPolynomial : std::vector<Rational>
{
    using std::vector<Rational>::vector;
};

RationalPolynomial operator+(const RationalPolynomial& a, const RationalPolynomial& b);
RationalPolynomial operator-(const RationalPolynomial& a, const RationalPolynomial& b);
RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b);
Rational value_at(const RationalPolynomial& p, const Rational& t);
RationalPolynomial greatest_common_divisor(RationalPolynomial a, RationalPolynomial b);

// How many distinct roots p has in (lo, hi].
int root_count(const RationalPolynomial& p, const Rational& lo, const Rational& hi);

// The only root of p in (lo, hi].
struct RealRoot
{
    RationalPolynomial p;  // without multiple roots
    Rational lo, hi;
};

std::vector<RealRoot> roots_between_0_and_1(const RationalPolynomial& p);  // ascending; p is not 0

int sign_at_root(const RationalPolynomial& h, RealRoot& root);  // narrows it as far as needed

bool is_at_most(const Rational& time, const RealRoot& root);

}  // namespace nuno
