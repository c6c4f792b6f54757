// The springs of a model as xpbd projects them all at once (sweep = jacobi): every vertex gathers what its springs ask
// of it and takes a share of that.
#pragma once

#include <span>
#include <vector>

#include "model/spring_weights.h"

namespace nuno {

// How often every spring is projected in a substep.
int jacobi_passes(const SimParams& params);

// Entries (slot * vertex_count + vertex, as SpringEntries) of
//     x_i' = x_i + w_i sum_j max(share - share_length / |d|, limit - limit_length / |d|) d,   d = x_j - x_i,
// w the inverse mass; limit and limit_length are empty without a strain limit, and below share where a spring is within
// it. The share of a spring is that of solver/xpbd/spring_share.h over max(1, D_i, D_j), D_i the sum over the springs
// of a vertex of the part of its excess that each alone would take away, at most 1 each. So in linear terms a pass is
// I - W K with K symmetric, W the inverse masses, and (Gershgorin) W K has its eigenvalues in [0, 1]: passes keep
// momentum, and pump no energy however stiff the springs (solver/xpbd/strip_sheet.h).
struct JacobiSprings
{
    std::uint32_t vertex_count = 0;
    int slot_count = 0;
    std::vector<std::uint32_t> neighbours;
    std::vector<float> share, share_length, limit, limit_length;
};

// `inverse_masses`: one a vertex. Bending by the stiffness D is left out; method_table refuses it.
JacobiSprings make_jacobi_springs(const ClothModel& model, const SimParams& params,
                                  std::span<const float> inverse_masses);

}  // namespace nuno
