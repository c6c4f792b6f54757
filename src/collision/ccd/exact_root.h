// Roots of polynomials in [0, 1] as exact numbers, and the signs of other polynomials at them.
#pragma once

#include <vector>

#include "collision/ccd/polynomial.h"

namespace nuno {

// Either the fraction lo = hi, or the only root of `polynomial` in [lo, hi], where it is simple and not at an end.
class ExactRoot
{
  public:
    explicit ExactRoot(Fraction at) : lo_(at), hi_(std::move(at)), is_fraction_(true) {}
    ExactRoot(Polynomial polynomial, Fraction lo, Fraction hi, int sign_at_lo);

    // Of p at the root. Narrows the bracket where that is needed to tell.
    int sign_of(const Polynomial& p);

    // Down to about 2e-15, in a few steps where double can guess the place.
    void narrow();
    double lower_bound() const { return rounded_down(lo_); }
    bool is_below(double time) const;

  private:
    void halve() { split_at(middle_of(lo_, hi_)); }
    void split_at(const Fraction& place);
    bool is_inside(double time) const;
    bool split_near(double guess, double half_width);
    double width() const { return rounded_down(hi_) - rounded_down(lo_); }
    double guess() const;

    Polynomial polynomial_;
    Fraction lo_, hi_;
    int sign_at_lo_ = 0;
    bool is_fraction_ = false, is_narrow_ = false;
};

// The distinct roots of p in [0, 1], in no order; p must not be 0.
std::vector<ExactRoot> roots_of(const Polynomial& p);

}  // namespace nuno
