// How long a substep of an explicit method may be.
#pragma once

#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// Upper bound of the largest angular frequency [rad/s] of the springs at rest: omega^2 <= max over vertices of
// 2 lambda_max(sum k n n^T) / m, since v^T K v = sum k (n.(v_i - v_j))^2 <= 2 sum_i v_i^T D_i v_i. On the seed's grid
// it is 4 (k + ks + kb) / m.
double omega_max_bound(const ClothModel& model, const SimParams& params);

// Threads may be stretched by this share of their length before the limits below are too long.
inline constexpr double kStretchAllowedFor = 0.2;

// Largest stable substep [s] at that bound, raised for stretched threads, with the damping ratio zeta = c / (2 omega)
// of the air damper: symplectic Euler 2 (sqrt(1 + zeta^2) - zeta) / omega; explicit Euler 2 zeta / omega for zeta <= 1,
// and never if undamped (0).
double largest_stable_substep(const ClothModel& model, const SimParams& params);

// Substeps a frame that keep the substep at or under the largest stable one; 0 where no number does.
int least_stable_substeps(const ClothModel& model, const SimParams& params);

}  // namespace nuno
