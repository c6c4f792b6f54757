// What an implicit step needs of a sheet, however its vertices are arranged: forces, energy, and a linear system.
#pragma once

#include <span>

#include "model/spring_weights.h"
#include "solver/implicit/sheet_rows.h"

namespace nuno {

// Where a sheet is and how fast it moves. x + x_low is the position, x_low what a float cannot hold of it: a rounded
// position alone would stretch fine, stiff cloth by more than its weight does.
struct SheetMotion
{
    SheetMotion() = default;
    explicit SheetMotion(std::size_t size) : x(size), x_low(size), v(size) {}
    Field3 x, x_low;  // [m]
    Field3 v;         // [m/s]
};

// One implicit stage: find v with x = x_bar + tau v and m (v - w) / tau = force(x, v).
struct StageTerms
{
    float tau;                // [s]
    float stiffness_damping;  // beta [s]
    // Where a step was tried, springs whose ends it moves apart by more than `bearable` of their length are as stiff across
    // as along: with d0 of length l0 along d at hand, k |d - d0|^2 / 2 is nowhere less than k (|d| - l0)^2 / 2, so that no
    // solution has more energy than the stage began with (Liu et al., Fast simulation of mass-spring systems, 2013).
    const Field3* tried = nullptr;  // [m]
    float bearable = 0;
};

class SheetSystem
{
  public:
    virtual ~SheetSystem() = default;
    virtual const SheetRows& rows() const = 0;
    // Place of a vertex of the model in the fields.
    virtual std::size_t place(std::uint32_t vertex) const = 0;

    virtual void set_springs(const ClothModel& model, std::span<const SpringWeight> weights) = 0;

    // These are called by every thread of the team; results are there after the team has waited.

    // Forces of springs and their dampers at `at`, their energy of each row (as step_energy counts it), and the matrix
    //   A = diag(mass) + (1 + damping / tau) K, K without what would make it indefinite.
    // mass [kg/s2]; 0 holds a vertex. `at` and `mass` must stay as they are while A is in use.
    virtual void assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                          std::span<double> row_energy, const Team& team) = 0;
    // z = B r, B close to the inverse of A, and r . z of each row; t is scratch.
    virtual void precondition(const Field3& r, Field3& z, Field3& t, std::span<double> row_dots, const Team& team) = 0;

    // What follows is of one row, once its arguments are there up to `reach` rows away.
    virtual int reach() const = 0;
    // Energy of the springs at `to`, and what their dampers take up in a stage, with the directions of `from`.
    virtual double step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms,
                               int row) const = 0;
    // q = A p; returns p . q.
    virtual double apply(const Field3& p, Field3& q, int row) const = 0;
    // r -= A p.
    virtual void subtract(const Field3& p, Field3& r, int row) const = 0;
};

}  // namespace nuno
