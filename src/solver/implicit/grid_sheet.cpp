// Forces and energy of a grid sheet.
#include "solver/implicit/grid_sheet.h"

#include <algorithm>
#include <cstdlib>

#include "solver/implicit/spring_pairs.h"

namespace nuno {
namespace {

// x_b - x_a of a pair, with what the rounded positions leave out.
NUNO_WIDE_INLINE RowVec difference(const SheetMotion& m, std::size_t a, std::size_t b)
{
    return (row_load(m.x, b) - row_load(m.x, a)) + (row_load(m.x_low, b) - row_load(m.x_low, a));
}

struct PairPointers
{
    const float *axial, *rest_length, *plate;
    std::size_t shift;             // from a place to where its springs are read
    float *along, *across, *pull;  // null where only energies are wanted

    NUNO_WIDE_INLINE PairSprings springs(std::size_t at) const
    {
        at += shift;
        return {RowLanes(axial + at), RowLanes(rest_length + at), RowLanes(plate + at)};
    }
};

NUNO_SIMD_CLONES double assemble_pairs(const SheetRows& rows, PairOffset offset, const PairPointers& p,
                                       const SheetMotion& at, const StageTerms& terms, int j)
{
    RowLanes energy{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t a = rows.at(i, j), b = rows.at(i + offset.i, j + offset.j);
        const auto change = [&](const Field3& of) NUNO_WIDE_LAMBDA { return row_load(of, b) - row_load(of, a); };
        const PairMotion motion{difference(at, a, b), terms.stiffness_damping > 0 ? change(at.v) : RowVec{},
                                terms.tried ? change(*terms.tried) : RowVec{}};
        const PairTerms pair = pair_terms(p.springs(a), motion, terms);
        pair.along.store(p.along + a);
        pair.across.store(p.across + a);
        pair.pull.store(p.pull + a);
        energy = energy + pair.energy;
    }
    return 0.5 * row_sum(energy);
}

NUNO_SIMD_CLONES double energy_of_pairs(const SheetRows& rows, PairOffset offset, const PairPointers& p,
                                        const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int j)
{
    RowLanes energy{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t a = rows.at(i, j), b = rows.at(i + offset.i, j + offset.j);
        RowVec before{}, u{};
        if (terms.stiffness_damping > 0) {
            before = row_load(from.x, b) - row_load(from.x, a);
            u = row_load(to.v, b) - row_load(to.v, a);
        }
        energy = energy + pair_energy(p.springs(a), difference(to, a, b), before, u, terms);
    }
    return 0.5 * row_sum(energy);
}

// Sum over the pairs of each vertex.
NUNO_SIMD_CLONES void gather_forces(const SheetRows& rows, const std::array<Field, kPairCount>& pull,
                                    const SheetMotion& at, Field3& force, int j)
{
    const std::array<std::size_t, kPairCount> steps = pair_steps(rows);
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        RowVec sum{};
#pragma GCC unroll 6
        for (std::size_t pair = 0; pair < kPairCount; ++pair) {
            const std::size_t next = place + steps[pair], back = place - steps[pair];
            sum = sum + row_load(pull[pair], place) * difference(at, place, next);
            sum = sum + row_load(pull[pair], back) * difference(at, place, back);
        }
        row_store(force, place, sum);
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
        for (Field& field : *fields) std::fill(field.begin(), field.end(), 0.0f);
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
    find_like_rows();
}

void GridSheet::find_like_rows()
{
    const SheetRows& rows = matrix_.rows;
    const auto same = [&](const std::array<Field, kPairCount>& fields, int a, int b) {
        return std::all_of(fields.begin(), fields.end(), [&](const Field& field) {
            const float* first = &field[rows.at(0, a)];
            return std::equal(first, first + rows.width, &field[rows.at(0, b)]);
        });
    };
    like_row_.assign(std::size_t(rows.rows), 0);
    for (int j = 1; j < rows.rows; ++j) {
        const int before = like_row_[std::size_t(j) - 1];
        const bool alike = same(axial_, before, j) && same(rest_length_, before, j) && same(matrix_.plate, before, j);
        like_row_[std::size_t(j)] = alike ? before : j;
    }
}

// What leads, modulo 2^64, from a place in this row to the same column of the row whose springs are like its own.
std::size_t GridSheet::springs_shift(int row) const
{
    return matrix_.rows.at(0, like_row_[std::size_t(row)]) - matrix_.rows.at(0, row);
}

// Fills a row of the matrix but for its diagonal; returns the energy of its springs.
double GridSheet::linearise(const SheetMotion& at, const StageTerms& terms, int row)
{
    const SheetRows& r = matrix_.rows;
    const std::size_t shift = springs_shift(row);
    double energy = 0;
    for (std::size_t k = 0; k < kPairCount; ++k)
        energy += assemble_pairs(r, kPairOffsets[k],
                                 {.axial = axial_[k].data(),
                                  .rest_length = rest_length_[k].data(),
                                  .plate = matrix_.plate[k].data(),
                                  .shift = shift,
                                  .along = matrix_.along[k].data(),
                                  .across = matrix_.across[k].data(),
                                  .pull = pull_[k].data()},
                                 at, terms, row);
    return energy;
}

void GridSheet::assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                         std::span<double> row_energy, const Team& team)
{
    if (team.leads()) {
        matrix_.mass = &mass;
        matrix_.x = &at.x;
        matrix_.fixed.clear();
        for (const std::size_t place : places_)
            if (mass[place] <= 0) matrix_.fixed.push_back(place);
    }
    team.wait();
    for_rows_in_turn(
        matrix_.rows, kGridReach, team, [&](int j) { row_energy[std::size_t(j)] = linearise(at, terms, j); },
        [&](int j) {
            gather_forces(matrix_.rows, pull_, at, force, j);
            invert_diagonal(matrix_, j);
        });
    multigrid_.coarsen(matrix_, team);
}

double GridSheet::step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int row) const
{
    const std::size_t shift = springs_shift(row);
    double energy = 0;
    for (std::size_t k = 0; k < kPairCount; ++k)
        energy += energy_of_pairs(matrix_.rows, kPairOffsets[k],
                                  {.axial = axial_[k].data(),
                                   .rest_length = rest_length_[k].data(),
                                   .plate = matrix_.plate[k].data(),
                                   .shift = shift,
                                   .along = nullptr,
                                   .across = nullptr,
                                   .pull = nullptr},
                                  from, to, terms, row);
    return energy;
}

void GridSheet::precondition(const Field3& r, Field3& z, Field3& t, std::span<double> row_dots, const Team& team)
{
    multigrid_.precondition(matrix_, r, z, t, row_dots, team);
}

}  // namespace nuno
