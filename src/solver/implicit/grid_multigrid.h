// Coarse levels of the matrix of a grid sheet, and the V-cycle over them: the preconditioner of the implicit methods.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/implicit/grid_matrix.h"
#include "solver/implicit/sheet_rows.h"

namespace nuno {

// The matrix of a coarse level as an energy,
//   1/2 sum over vertices |x|^2_anchor + 1/2 sum over pairs |x_a - x_b|^2_link,
// pairs with the vertex to the right, below, and on both diagonals below; the plate has pairs two cells away, too.
// Vertex (i, j) stands for (2 i, 2 j) of the level above.
struct CoarseLevel
{
    CoarseLevel(int columns, int rows);

    SheetRows rows;
    Field6 anchor;
    std::array<Field6, 4> links;
    Field6 inverse_diagonal;
    std::array<Field, kPairCount> plate;  // empty where the cloth has none
    Field plate_diagonal;                 // what the plate adds to the diagonal beyond its share in the links
    Field3 x, r, t;
};

// The coarse levels, whatever the finest one below them is.
class CoarseGrids
{
  public:
    // Levels of half the columns and rows each, from this one on.
    CoarseGrids(int columns, int rows);

    CoarseLevel& first() { return levels_.front(); }
    // Takes over the plate of the level above, which stays until it is set again; none: an empty one.
    void set_plate(const SheetRows& above, const std::array<Field, kPairCount>* plate);
    // Makes the other levels from the anchors and links of the first, and prepares all. Called by all of the team.
    void prepare(const Team& team);
    // first().x = B first().r. Called by all of the team once first().r is there.
    void solve(const Team& team);

  private:
    void cycle(std::size_t level, const Team& team);

    std::vector<CoarseLevel> levels_;
    bool has_plate_ = false;
    std::vector<double> factor_, solution_;  // of the coarsest level: its Cholesky factor by rows
};

class GridMultigrid
{
  public:
    explicit GridMultigrid(const SheetRows& fine) : coarse_((fine.columns + 1) / 2, (fine.rows + 1) / 2) {}

    void set_plate(const GridMatrix& fine) { coarse_.set_plate(fine.rows, fine.has_plate ? &fine.plate : nullptr); }
    // Makes the coarse levels of `fine`. Called by all of the team.
    void coarsen(const GridMatrix& fine, const Team& team);
    // z = B r, B close to the inverse of the matrix and positive definite, and r . z of each row. r is 0 where a vertex
    // is fixed; t is scratch.
    void precondition(const GridMatrix& fine, const Field3& r, Field3& z, Field3& t, std::span<double> row_dots,
                      const Team& team);

  private:
    CoarseGrids coarse_;
};

}  // namespace nuno
