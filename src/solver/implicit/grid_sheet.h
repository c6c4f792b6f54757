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
    void step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms,
                     std::span<double> row_energy, const Team& team) const override;
    void apply(const Field3& p, Field3& q, std::span<double> row_dots, const Team& team) const override;
    void precondition(const Field3& r, Field3& z, Field3& t, const Team& team) override;

  private:
    std::uint32_t first_vertex_, vertex_count_;
    std::vector<std::size_t> places_;
    GridMatrix matrix_;
    GridMultigrid multigrid_;
    std::array<Field, kPairCount> axial_, rest_length_;  // [N/m], [m]
    std::array<Field, kPairCount> pull_;                 // force of a pair over its d [N/m], of the last assemble
};

}  // namespace nuno
