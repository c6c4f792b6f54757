// Preconditioned conjugate gradients.
#include "solver/implicit/conjugate_gradients.h"

#include <algorithm>

namespace nuno {

ConjugateGradients::ConjugateGradients(const SheetRows& rows)
    : rows_(rows),
      p_(rows.size()),
      q_(rows.size()),
      z_(rows.size()),
      t_(rows.size()),
      row_rz_(std::size_t(rows.rows)),
      row_pq_(std::size_t(rows.rows))
{
}

NUNO_SIMD_CLONES void scale(const SheetRows& rows, float s, const Field3& a, Field3& to, int row)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, row);
        row_store(to, place, RowLanes(s) * row_load(a, place));
    }
}

NUNO_SIMD_CLONES void add_scaled(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to,
                                 int row)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, row);
        row_store(to, place, row_load(from, place) + RowLanes(s) * row_load(step, place));
    }
}

void add_scaled(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to, const Team& team)
{
    for_rows(rows, team, [&](int j) { add_scaled(rows, from, s, step, to, j); });
}

SolveResult ConjugateGradients::solve(SheetSystem& system, Field3& r, const Field3* guess, Field3& d,
                                      const SolveLimits& limits, const Team& team)
{
    SolveResult result{0, 0};
    if (guess) for_rows(rows_, team, [&](int j) { system.subtract(*guess, r, j); });
    team.wait();
    const Field3* so_far = guess;
    double before = 0;
    for (;; ++result.iterations) {
        system.precondition(r, z_, t_, row_rz_, team);
        const double rz = team.sum(row_rz_);
        if (result.iterations == 0) result.target_sq = limits.error_sq + limits.error_share * std::max(0.0, rz);
        if (!(rz > result.target_sq) || result.iterations == limits.most_iterations) break;
        const auto keep = static_cast<float>(result.iterations == 0 ? 0 : rz / before);
        const auto turn = [&](int j) {
            // The first search direction is z itself, whatever an earlier solve left in p.
            if (result.iterations == 0)
                scale(rows_, 1.0f, z_, p_, j);
            else
                add_scaled(rows_, z_, keep, p_, p_, j);
        };
        for_rows_in_turn(rows_, system.reach(), team, turn,
                         [&](int j) { row_pq_[std::size_t(j)] = system.apply(p_, q_, j); });
        before = rz;
        const double pq = team.sum(row_pq_);
        if (!(pq > 0)) break;
        const auto alpha = static_cast<float>(rz / pq);
        for_rows(rows_, team, [&](int j) {
            if (so_far)
                add_scaled(rows_, *so_far, alpha, p_, d, j);
            else
                scale(rows_, alpha, p_, d, j);
            add_scaled(rows_, r, -alpha, q_, r, j);
        });
        so_far = &d;
        team.wait();
    }
    // The last correction, not searched along, is a step of the V-cycle alone: it shortens the error again.
    for_rows(rows_, team, [&](int j) {
        if (so_far)
            add_scaled(rows_, *so_far, 1.0f, z_, d, j);
        else
            scale(rows_, 1.0f, z_, d, j);
    });
    team.wait();
    return result;
}

}  // namespace nuno
