// What vertex block descent makes of the parameters, for both backends.
#pragma once

#include <vector>

#include "model/cloth_model.h"
#include "model/spring_weights.h"

namespace nuno {

struct VbdTerms
{
    float h, inverse_h;      // [s], [1/s]
    float damper;            // Rayleigh beta over h
    float longest, stiffer;  // strain limit: 1 + limit, and with_limit's factor; stiffer is 0 without one
    int iterations;          // each a sweep over the colours and its exact reverse
};

VbdTerms vbd_terms(const ClothModel& model, const SimParams& params);

// Springs no stiffer along their line than the sweeps can make good: at most 3 m / h^2 for each iteration, m the
// heavier end. Where they are far stiffer, sweeps leave the low modes unsolved and correct the others along directions
// that turn with the cloth: forces that follow it, from which a sheet at rest flutters (measured on `hang`, 64 x 64 and
// 2 iterations of 1/300 s: with k = 500 m / h^2 0.7 J of motion are left after 10 s, capped 0.01 J, and less strain).
std::vector<SpringWeight> vbd_spring_weights(const ClothModel& model, const SimParams& params);
bool vbd_spring_weights_differ(const SimParams& a, const SimParams& b);
inline constexpr SpringRule kVbdSprings{vbd_spring_weights, vbd_spring_weights_differ};

}  // namespace nuno
