// Where a grid cannot touch itself, by the monotonicity of its surface over its rest shape (docs/tree.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/kernels.h"

namespace nuno {

// Flags for squares of 2^n cells, n = 2, 3 .. up to the whole grid, at positions over a step. Keeps its storage.
class GridProof
{
  public:
    GridProof(const GridPatch& grid, std::span<const glm::vec3> rest_positions);

    // Forgets the edges of the last step.
    void clear();
    // Where bands of rows are added, each by one thread: EdgeLevel of blocks of 4 x 4 cells.
    const EdgeLevel& base() const { return levels_.front(); }
    // In every window whose flag is set, faces without a common vertex are more than the distance and the margin apart,
    // or more than the margin and the share of their distance at rest.
    void prove(const TreeSettings& settings, const TreeKernels& kernels);

    // Cell by cell, what was left open there of a band's rows; each band by one thread, after prove().
    void prove_cells(const BoxFrame& frame, const GridBand& band, const TreeKernels& kernels, RowScratch& rows);

    bool holds_for_all() const { return flags_.back()[0] & 1; }
    // Of nodes of a level of the tree; those of level 0 have none.
    ProofLevel level(int level) const;
    // Whether contacts of cell (i, j) with itself and with the cells around it are ruled out.
    bool is_apart_from_neighbours(int i, int j) const;
    // GridBand::open_blocks, row by row.
    const std::uint8_t* open_blocks() const { return open_.data(); }
    int block_columns() const { return base().width; }
    const std::uint16_t* apart_cells() const { return apart_cells_.data(); }  // GridBand::apart_cells

  private:
    void find_open_blocks();

    // Whether contacts of a row of blocks are left open.
    bool is_open_row(int block_row) const;

    float need_ = 0;  // [m] what lambda has to exceed
    int cell_groups_;
    float rest_spacing_;  // [m] that points one cell apart are apart at rest, at most
    std::vector<std::vector<float>> storage_;
    std::vector<EdgeLevel> levels_;
    std::vector<std::vector<std::uint8_t>> flags_;
    std::vector<std::uint8_t> open_;
    std::vector<std::uint16_t> apart_cells_;
};

}  // namespace nuno
