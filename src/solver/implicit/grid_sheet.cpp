// Forces and energy of a grid sheet.
#include "solver/implicit/grid_sheet.h"

#include <cstdlib>

namespace nuno {
namespace {

constexpr float kLeastLengthSq = 1e-24f;

// x_b - x_a of a pair, with what the rounded positions leave out.
NUNO_WIDE_INLINE RowVec difference(const SheetMotion& m, std::size_t a, std::size_t b)
{
    return (row_load(m.x, b) - row_load(m.x, a)) + (row_load(m.x_low, b) - row_load(m.x_low, a));
}

struct PairPointers
{
    const float *axial, *rest_length, *plate;
    float *along, *across, *pull;
};

// A pair of length l at rest l0: energy k (l - l0)^2 / 2, force k (1 - l0 / l) d, and of its matrix
// k [n n^T + max(0, 1 - l0 / l) (I - n n^T)]; the damper beta k n n^T; the plate's share w of linear stiffness.
NUNO_SIMD_CLONES double assemble_pairs(const SheetRows& rows, PairOffset offset, const PairPointers& p,
                                       const SheetMotion& at, const StageTerms& terms, int j)
{
    RowLanes energy{};
    const RowLanes damping = row_all(terms.stiffness_damping), rate = row_all(terms.stiffness_damping / terms.tau);
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t a = rows.at(i, j), b = rows.at(i + offset.i, j + offset.j);
        const RowVec d = difference(at, a, b);
        const RowLanes axial = row_load(p.axial + a), rest = row_load(p.rest_length + a), plate = row_load(p.plate + a);
        const RowLanes length_sq = row_max(row_dot(d, d), row_all(kLeastLengthSq)), length = row_sqrt(length_sq);
        const RowLanes inverse = row_all(1.0f) / length, inverse_sq = inverse * inverse;
        const RowLanes taut = axial * row_min(row_all(1.0f), rest * inverse);
        const RowLanes stretch = length - rest;
        RowLanes pull = axial * stretch * inverse + plate;
        energy += axial * stretch * stretch + plate * length_sq;
        RowLanes along = taut * inverse_sq;
        if (terms.stiffness_damping > 0) {
            const RowLanes speed = row_dot(d, row_load(at.v, b) - row_load(at.v, a));
            pull += damping * axial * inverse_sq * speed;
            along += rate * axial * inverse_sq;
            energy += row_all(terms.tau) * damping * axial * inverse_sq * speed * speed;
        }
        row_store(p.along + a, along);
        row_store(p.across + a, plate + (axial - taut));
        row_store(p.pull + a, pull);
    }
    return 0.5 * row_sum(energy);
}

NUNO_SIMD_CLONES double energy_of_pairs(const SheetRows& rows, PairOffset offset, const PairPointers& p,
                                        const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int j)
{
    RowLanes energy{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t a = rows.at(i, j), b = rows.at(i + offset.i, j + offset.j);
        const RowVec d = difference(to, a, b);
        const RowLanes axial = row_load(p.axial + a), plate = row_load(p.plate + a);
        const RowLanes length_sq = row_max(row_dot(d, d), row_all(kLeastLengthSq));
        const RowLanes stretch = row_sqrt(length_sq) - row_load(p.rest_length + a);
        energy += axial * stretch * stretch + plate * length_sq;
        if (terms.stiffness_damping > 0) {
            const RowVec before = row_load(from.x, b) - row_load(from.x, a);
            const RowLanes speed = row_dot(before, row_load(to.v, b) - row_load(to.v, a));
            energy += row_all(terms.tau * terms.stiffness_damping) * axial * speed * speed /
                      row_max(row_dot(before, before), row_all(kLeastLengthSq));
        }
    }
    return 0.5 * row_sum(energy);
}

// Sum over the pairs of each vertex.
NUNO_SIMD_CLONES void gather_forces(const SheetRows& rows, const std::array<Field, kPairCount>& pull,
                                    const SheetMotion& at, Field3& force, Field3& x, int j)
{
    const auto stride = std::size_t(rows.stride);
    const std::size_t steps[kPairCount] = {1, stride, stride + 1, stride - 1, 2, 2 * stride};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        RowVec sum{};
#pragma GCC unroll 6
        for (int pair = 0; pair < kPairCount; ++pair) {
            const std::size_t next = place + steps[pair], back = place - steps[pair];
            sum = sum + row_load(pull[pair].get() + place) * difference(at, place, next);
            sum = sum + row_load(pull[pair].get() + back) * difference(at, place, back);
        }
        row_store(force, place, sum);
        row_store(x, place, row_load(at.x, place));
    }
}

}  // namespace

GridSheet::GridSheet(const Sheet& sheet)
    : first_vertex_(sheet.first_vertex),
      vertex_count_(sheet.vertex_count),
      places_(sheet.vertex_count),
      matrix_(SheetRows(sheet.columns, sheet.rows)),
      multigrid_(matrix_.rows)
{
    for (int j = 0; j < sheet.rows; ++j)
        for (int i = 0; i < sheet.columns; ++i)
            places_[sheet.grid_vertex(i, j) - first_vertex_] = matrix_.rows.at(i, j);
    for (auto* fields : {&axial_, &rest_length_, &pull_})
        for (Field& field : *fields) field = Field(matrix_.rows.size());
}

void GridSheet::set_springs(const ClothModel& model, std::span<const SpringWeight> weights)
{
    for (auto* fields : {&axial_, &rest_length_, &matrix_.plate})
        for (Field& field : *fields) std::fill(field.get(), field.get() + matrix_.rows.size(), 0.0f);
    matrix_.has_plate = false;
    const auto stride = std::ptrdiff_t(matrix_.rows.stride);
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        if (spring.a < first_vertex_ || spring.a >= first_vertex_ + vertex_count_) continue;
        const auto a = std::ptrdiff_t(place(spring.a)), b = std::ptrdiff_t(place(spring.b));
        for (std::size_t pair = 0; pair < kPairCount; ++pair) {
            if (std::abs(b - a) != kPairOffsets[pair].j * stride + kPairOffsets[pair].i) continue;
            const auto first = std::size_t(std::min(a, b));
            axial_[pair][first] += weights[s].axial;
            rest_length_[pair][first] = spring.rest_length;
            matrix_.plate[pair][first] += weights[s].plate;
            matrix_.has_plate = matrix_.has_plate || weights[s].plate != 0;
        }
    }
    multigrid_.set_plate(matrix_);
}

void GridSheet::assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                         std::span<double> row_energy, const Team& team)
{
    const SheetRows& r = matrix_.rows;
    const Range part = team.part(r.rows);
    for (int j = part.begin; j < part.end; ++j) {
        double energy = 0;
        for (std::size_t k = 0; k < kPairCount; ++k)
            energy += assemble_pairs(r, kPairOffsets[k],
                                     {axial_[k].get(), rest_length_[k].get(), matrix_.plate[k].get(),
                                      matrix_.along[k].get(), matrix_.across[k].get(), pull_[k].get()},
                                     at, terms, j);
        row_energy[std::size_t(j)] = energy;
        std::memcpy(matrix_.mass.get() + r.at(0, j), mass.get() + r.at(0, j), std::size_t(r.width) * sizeof(float));
    }
    team.wait();
    if (team.leads()) {
        matrix_.fixed.clear();
        for (const std::size_t place : places_)
            if (mass[place] <= 0) matrix_.fixed.push_back(place);
    }
    for (int j = part.begin; j < part.end; ++j) gather_forces(r, pull_, at, force, matrix_.x, j);
    team.wait();
    invert_diagonal(matrix_, team);
    multigrid_.coarsen(matrix_, team);
}

void GridSheet::step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms,
                            std::span<double> row_energy, const Team& team) const
{
    const Range part = team.part(matrix_.rows.rows);
    for (int j = part.begin; j < part.end; ++j) {
        double energy = 0;
        for (std::size_t k = 0; k < kPairCount; ++k)
            energy += energy_of_pairs(
                matrix_.rows, kPairOffsets[k],
                {axial_[k].get(), rest_length_[k].get(), matrix_.plate[k].get(), nullptr, nullptr, nullptr}, from, to,
                terms, j);
        row_energy[std::size_t(j)] = energy;
    }
}

void GridSheet::apply(const Field3& p, Field3& q, std::span<double> row_dots, const Team& team) const
{
    nuno::apply(matrix_, p, q, row_dots, team);
}

void GridSheet::precondition(const Field3& r, Field3& z, Field3& t, const Team& team)
{
    multigrid_.precondition(matrix_, r, z, t, team);
}

}  // namespace nuno
