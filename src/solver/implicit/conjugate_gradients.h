// Preconditioned conjugate gradients on one sheet, and the sums over vectors that they need.
#pragma once

#include <vector>

#include "solver/implicit/sheet_system.h"

namespace nuno {

struct SolveLimits
{
    double error_sq;     // energy norm squared of the error that may be left, as the preconditioner sees it [J] ...
    double error_share;  // ... plus this share of that of the solution
    int most_iterations;
};

struct SolveResult
{
    int iterations;
    double target_sq;  // what the error was to be at most, as the preconditioner sees it [J]
};

class ConjugateGradients
{
  public:
    explicit ConjugateGradients(const SheetRows& rows);

    // Solves A d = r, from the guess (0 without one); r is spent. Called by all of the team, which gets
    // the same result.
    SolveResult solve(SheetSystem& system, Field3& r, const Field3* guess, Field3& d, const SolveLimits& limits,
                      const Team& team);

  private:
    SheetRows rows_;
    Field3 p_, q_, z_, t_;
    std::vector<double> row_rz_, row_pq_;
};

// to = s a, and to = from + s step, in one row.
void scale(const SheetRows& rows, float s, const Field3& a, Field3& to, int row);
void add_scaled(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to, int row);
// The latter in every row of the team's part.
void add_scaled(const SheetRows& rows, const Field3& from, float s, const Field3& step, Field3& to, const Team& team);

}  // namespace nuno
