// Preconditioned conjugate gradients.
#include "solver/implicit/conjugate_gradients.h"

namespace nuno {
namespace {

NUNO_SIMD_CLONES double dot_row(const SheetRows& rows, const Field3& a, const Field3& b, int j)
{
    RowLanes sum{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        sum = sum + row_dot(row_load(a, place), row_load(b, place));
    }
    return row_sum(sum);
}

NUNO_SIMD_CLONES void add_row(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to, int j)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        row_store(to, place, row_load(from, place) + RowLanes(s) * row_load(step, place));
    }
}

}  // namespace

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

void add_scaled(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to, const Team& team)
{
    for_rows(rows, team, [&](int j) { add_row(rows, from, s, step, to, j); });
}

SolveResult ConjugateGradients::solve(SheetSystem& system, Field3& r, Field3& d, const SolveLimits& limits,
                                      const Team& team)
{
    SolveResult result{0, 0};
    system.apply(d, q_, row_pq_, team);
    add_scaled(rows_, r, -1.0f, q_, r, team);
    team.wait();
    double before = 0;
    for (;; ++result.iterations) {
        system.precondition(r, z_, t_, team);
        for_rows(rows_, team, [&](int j) { row_rz_[std::size_t(j)] = dot_row(rows_, r, z_, j); });
        const double rz = team.sum(row_rz_);
        if (result.iterations == 0) result.target_sq = limits.error_sq + limits.error_share * rz;
        if (!(rz > result.target_sq) || result.iterations == limits.most_iterations) break;
        // The first search direction is z itself, whatever an earlier solve left in p.
        if (result.iterations == 0)
            add_scaled(rows_, z_, 0.0f, z_, p_, team);
        else
            add_scaled(rows_, z_, static_cast<float>(rz / before), p_, p_, team);
        before = rz;
        team.wait();
        system.apply(p_, q_, row_pq_, team);
        const double pq = team.sum(row_pq_);
        if (!(pq > 0)) break;
        const auto alpha = static_cast<float>(rz / pq);
        add_scaled(rows_, d, alpha, p_, d, team);
        add_scaled(rows_, r, -alpha, q_, r, team);
        team.wait();
    }
    // The last correction, not searched along, is a step of the V-cycle alone: it shortens the error again.
    add_scaled(rows_, d, 1.0f, z_, d, team);
    team.wait();
    return result;
}

}  // namespace nuno
