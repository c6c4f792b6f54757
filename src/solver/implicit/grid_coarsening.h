// From one level of a grid to the next coarser one: matrices, residuals and corrections.
#pragma once

#include "solver/implicit/grid_multigrid.h"

namespace nuno {

// Level 0 from the sheet itself, and each other level from the one above it. Columns and rows halve, rounded up; the
// last vertex of an even number hangs on the coarse one before it. Links keep the stretch of smooth displacements and
// are otherwise stiffer than those of the Galerkin product, which is safe. The plate is left out.
void coarsen_sheet(const GridMatrix& fine, CoarseLevel& coarse, const Team& team);
void coarsen_level(const CoarseLevel& fine, CoarseLevel& coarse, const Team& team);

// coarse = P^T fine, P bilinear.
void restrict_rows(const SheetRows& fine_rows, const Field3& fine, const SheetRows& coarse_rows, Field3& coarse,
                   const Team& team);

// fine += P coarse in one row of it, where `mass` is positive, or everywhere without it.
void prolong(const SheetRows& coarse_rows, const Field3& coarse, const SheetRows& fine_rows, Field3& fine,
             const Field* mass, int row);

}  // namespace nuno
