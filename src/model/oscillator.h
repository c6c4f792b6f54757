// Stability of the explicit methods on an oscillator, from the update formulas themselves.
#pragma once

#include <array>

#include "model/sim_params.h"

namespace nuno {

// a = -omega^2 x - rate v.
struct Oscillator
{
    double omega;  // [rad/s]
    double rate;   // [1/s]
};

// True where no solution of `method` with substep h [s] grows: every root of the characteristic polynomial of the
// linear map that a substep applies to the state is within the unit circle (criterion of Jury).
bool is_stable(Method method, const Oscillator& oscillator, double h);

// The smallest h [s] from which on `method` is no longer stable; 0 where no h is. Method must be explicit.
double stable_until(Method method, const Oscillator& oscillator);

// The methods whose substep has a limit.
inline constexpr std::array<Method, 4> kExplicitMethods{Method::explicit_euler, Method::symplectic_euler,
                                                        Method::verlet, Method::rk4};
bool is_explicit(Method method);

}  // namespace nuno
