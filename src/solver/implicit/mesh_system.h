// A sheet that is no grid as the implicit methods see it: each vertex gathers from its neighbours. Where the sheet is
// flat at rest, a grid laid over it is the next coarser level; elsewhere the preconditioner is block Jacobi.
#pragma once

#include <optional>
#include <vector>

#include "model/cloth_model.h"
#include "solver/implicit/mesh_overlay.h"
#include "solver/implicit/sheet_system.h"

namespace nuno {

// Neighbours of every vertex, slot by slot: entry slot * size + place. A slot without a spring names the vertex itself
// and has no stiffness.
struct MeshPairs
{
    std::size_t size = 0;
    std::vector<int> slots_of_row;
    std::vector<std::uint32_t> neighbours;  // places
    std::vector<std::uint32_t> springs;     // of the model; SpringTable::kNoSpring
    Field axial, rest_length, plate;
    Field along, across;  // as GridMatrix has them, at the last assemble
};

class MeshSystem final : public SheetSystem
{
  public:
    MeshSystem(const ClothModel& model, const Sheet& sheet);

    const SheetRows& rows() const override { return rows_; }
    std::size_t place(std::uint32_t vertex) const override;
    void set_springs(const ClothModel& model, std::span<const SpringWeight> weights) override;
    void assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                  std::span<double> row_energy, const Team& team) override;
    void precondition(const Field3& r, Field3& z, Field3& t, std::span<double> row_dots, const Team& team) override;
    int reach() const override { return rows_.rows; }
    double step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int row) const override;
    double apply(const Field3& p, Field3& q, int row) const override;
    void subtract(const Field3& p, Field3& r, int row) const override;

  private:
    std::uint32_t first_vertex_;
    SheetRows rows_;
    MeshPairs pairs_;
    Field mass_;
    Field3 x_;
    Field6 inverse_diagonal_;
    std::optional<MeshOverlay> overlay_;
};

}  // namespace nuno
