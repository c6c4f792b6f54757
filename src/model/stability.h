// How long a substep of an explicit method may be.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "model/cloth_model.h"
#include "model/cloth_state.h"
#include "model/oscillator.h"
#include "model/sim_params.h"

namespace nuno {

// Upper bound of the largest angular frequency [rad/s] at rest. Springs and plate: omega^2 <= max over vertices of
// 2 lambda_max(sum k n n^T) / m, since v^T K v = sum k (n.(v_i - v_j))^2 <= 2 sum_i v_i^T D_i v_i; on the seed's grid
// it is 4 (k + ks + kb) / m. Membrane: the largest of the faces one by one, each with its share of the vertices' mass
// (Irons and Treharne 1971). The squares add up.
double omega_max_bound(const ClothModel& model, const SimParams& params);

// The largest angular frequency at a state, by power iteration on M^-1 K: from below, 0.1 % low or less after the 80
// products that a cold start takes, pinned and held vertices at rest. `mode` holds where to start and where it ended:
// with the one of a state nearby 10 products do; empty, it starts from the same noise always.
double omega_max(const ClothModel& model, const SimParams& params, const ClothState& state,
                 std::vector<glm::dvec3>& mode);

// Cloth may be stretched by this share of its length before the limits of a cloth at rest are too long.
inline constexpr double kStretchAllowedFor = 0.2;

// The largest stable substep [s] of a method that is stable with any.
inline constexpr double kAnySubstep = 1e9;

// Largest substep [s] at which params.method is stable for every mode up to omega [rad/s], with the damper of the air,
// rate c = damping / areal_density, and Rayleigh damping beta omega^2; 0 where none is.
double largest_stable_substep(const SimParams& params, double omega);

// The same at the bound, raised for cloth stretched by the share `stretch`: of a spring to l from l0 by 2 - l0 / l in
// omega^2, which is 2 however far, of the membrane, which stiffens, by (1 + e)^2 + e + e^2 / 2 at the stretch e. The
// air of wind_model aero counts as a damper at the speed of the wind.
double largest_stable_substep(const ClothModel& model, const SimParams& params, double stretch = kStretchAllowedFor);

// Substeps a frame that keep the substep at or under the largest stable one; 0 where no number does.
int least_stable_substeps(const ClothModel& model, const SimParams& params, double stretch = kStretchAllowedFor);

// How far the faces are stretched, at most and in any direction, where the cloth is now or would be `ahead_s` [s] later
// at its velocity: 0 at rest or less.
double largest_face_stretch(const ClothModel& model, const ClothState& state, double ahead_s);

// How stable the explicit methods are where the cloth is now.
struct PresentStability
{
    double omega_max, omega_bound;           // [rad/s], by iteration (from below) and at rest (from above)
    std::array<double, 4> stable_substep_s;  // at omega_max, of each of kExplicitMethods; 0 where none is
    double largest_stable_substep_s;         // of params.method
    int least_substeps;                      // of params.method, with 5 % to spare; 0 where no number holds
};
PresentStability present_stability(const ClothModel& model, const SimParams& params, const ClothState& state,
                                   std::vector<glm::dvec3>& mode);

}  // namespace nuno
