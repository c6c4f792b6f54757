// A grid sheet as the implicit methods see it: pairs of neighbours in rows, multigrid.
#pragma once

#include <array>
#include <vector>

#include "model/cloth_model.h"
#include "solver/implicit/grid_multigrid.h"
#include "solver/implicit/sheet_system.h"

namespace nuno {

class GridSheet final : public SheetSystem
{
  public:
    explicit GridSheet(const Sheet& sheet);

    const SheetRows& rows() const override { return matrix_.rows; }
    std::size_t place(std::uint32_t vertex) const override { return places_[vertex - first_vertex_]; }
    void set_springs(const ClothModel& model, std::span<const SpringWeight> weights) override;
    void assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                  std::span<double> row_energy, const Team& team) override;
    void precondition(const Field3& r, Field3& z, Field3& t, std::span<double> row_dots, const Team& team) override;
    int reach() const override { return kGridReach; }
    double step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int row) const override;
    double apply(const Field3& p, Field3& q, int row) const override { return nuno::apply(matrix_, p, q, row); }
    void subtract(const Field3& p, Field3& r, int row) const override { residual(matrix_, p, r, r, row); }

  private:
    void find_like_rows();
    std::size_t springs_shift(int row) const;
    double linearise(const SheetMotion& at, const StageTerms& terms, int row);

    std::uint32_t first_vertex_, vertex_count_;
    std::vector<std::size_t> places_;
    GridMatrix matrix_;
    GridMultigrid multigrid_;
    std::array<Field, kPairCount> axial_, rest_length_;  // [N/m], [m]
    std::vector<int> like_row_;  // of each row: the first one whose springs are the same, which stays in the cache
    std::array<Field, kPairCount> pull_;  // force of a pair over its d [N/m], of the last assemble
};

}  // namespace nuno
