// Springs between pairs of vertices as the implicit methods linearise them, sixteen at a time, whatever the sheet.
#pragma once

#include "solver/implicit/sheet_system.h"

namespace nuno {

struct PairSprings
{
    RowLanes axial, rest_length, plate;  // [N/m], [m], [N/m]: the plate's share of linear stiffness, of either sign
};

struct PairTerms
{
    RowLanes along, across;  // the pair's matrix: along d d^T + across I [N/m3], [N/m]
    RowLanes pull;           // its force over d [N/m]
    RowLanes energy;         // twice its energy [J], as pair_energy counts it
};

constexpr float kLeastLengthSq = 1e-24f;

// A pair of length l at rest l0: energy k (l - l0)^2 / 2, force k (1 - l0 / l) d, and of its matrix
// k [n n^T + max(0, 1 - l0 / l) (I - n n^T)]; the damper beta k n n^T; the plate's share w of linear stiffness.
// d = x_b - x_a, and the same of the velocity, which only the damper reads, and of the step that was tried, if one was.
struct PairMotion
{
    RowVec d, u, tried;
};

NUNO_WIDE_INLINE PairTerms pair_terms(const PairSprings& s, const PairMotion& motion, const StageTerms& terms)
{
    const RowLanes one(1.0f);
    const RowVec &d = motion.d, &u = motion.u;
    const RowLanes length_sq = max_real(row_dot(d, d), RowLanes(kLeastLengthSq)), length = sqrt_real(length_sq);
    const RowLanes inverse = one / length, inverse_sq = inverse * inverse, stretch = length - s.rest_length;
    RowLanes taut = s.axial * min_real(one, s.rest_length * inverse);
    if (terms.tried) {
        const RowLanes bearable_sq = RowLanes(terms.bearable * terms.bearable) * length_sq;
        taut = select_positive(row_dot(motion.tried, motion.tried) - bearable_sq, RowLanes{}, taut);
    }
    PairTerms pair{.along = taut * inverse_sq,
                   .across = s.plate + (s.axial - taut),
                   .pull = s.axial * stretch * inverse + s.plate,
                   .energy = s.axial * stretch * stretch + s.plate * length_sq};
    if (terms.stiffness_damping > 0) {
        const RowLanes damping(terms.stiffness_damping), rate(terms.stiffness_damping / terms.tau);
        const RowLanes speed = row_dot(d, u), damper = damping * s.axial * inverse_sq * speed;
        pair.along = pair.along + rate * s.axial * inverse_sq;
        pair.pull = pair.pull + damper;
        pair.energy = pair.energy + RowLanes(terms.tau) * damper * speed;
    }
    return pair;
}

// Twice the energy of a pair at d, and of what its damper takes up in a stage, with the direction of `before`.
NUNO_WIDE_INLINE RowLanes pair_energy(const PairSprings& s, const RowVec& d, const RowVec& before, const RowVec& u,
                                      const StageTerms& terms)
{
    const RowLanes least(kLeastLengthSq), length_sq = max_real(row_dot(d, d), least);
    const RowLanes stretch = sqrt_real(length_sq) - s.rest_length;
    const RowLanes energy = s.axial * stretch * stretch + s.plate * length_sq;
    if (!(terms.stiffness_damping > 0)) return energy;
    const RowLanes speed = row_dot(before, u), c = RowLanes(terms.tau * terms.stiffness_damping) * s.axial;
    return energy + c * speed * speed / max_real(row_dot(before, before), least);
}

}  // namespace nuno
