// How much of a spring's excess one projection takes away.
#pragma once

#include <cmath>

namespace nuno {

// Projected `projections` times, a spring alone ends where backward Euler puts it: with alpha / (W + alpha) of its
// excess, W the inverse masses of its ends together, alpha = 1 / (k h^2) in the same unit. Each projection leaves that
// to the power 1 / projections. The share is what the excess is multiplied by for one unit of inverse mass.
inline double spring_share(double inverse_masses, double stiffness, double h, int projections)
{
    if (inverse_masses <= 0 || stiffness <= 0) return 0;
    const double alpha = 1 / (stiffness * h * h), kept = alpha / (inverse_masses + alpha);
    const double kept_once = projections == 2 ? std::sqrt(kept) : std::pow(kept, 1.0 / projections);
    return (1 - kept_once) / inverse_masses;
}

}  // namespace nuno
