// What the kernels of any matrix A of a sheet do in a row: `product(place)` is A u there, for a field u.
#pragma once

#include "solver/implicit/row_fields.h"
#include "solver/implicit/sheet_rows.h"

namespace nuno {

// v, or 0 where a vertex is held.
NUNO_WIDE_INLINE RowVec where_free(const Field& mass, std::size_t place, const RowVec& v)
{
    return select_positive(row_load(mass, place), v, RowVec{});
}

// to = A u; returns u . to.
template <class Product>
NUNO_WIDE_INLINE double apply_row(const SheetRows& rows, const Field& mass, const Field3& u, Field3& to, int j,
                                  const Product& product)
{
    RowLanes sum{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const RowVec y = where_free(mass, place, product(place));
        row_store(to, place, y);
        sum = sum + row_dot(row_load(u, place), y);
    }
    return row_sum(sum);
}

// to = r - A u; to may be r.
template <class Product>
NUNO_WIDE_INLINE void defect_row(const SheetRows& rows, const Field& mass, const Field3& r, Field3& to, int j,
                                 const Product& product)
{
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        row_store(to, place, where_free(mass, place, row_load(r, place) - product(place)));
    }
}

// A step of damped Jacobi, to = u + w D^-1 (r - A u), D the blocks of A's diagonal; returns r . to.
template <class Product>
NUNO_WIDE_INLINE double smooth_row(const SheetRows& rows, const Field6& inverse_diagonal, const Field3& u,
                                   const Field3& r, Field3& to, int j, const Product& product)
{
    RowLanes sum{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const RowVec goal = row_load(r, place), defect = goal - product(place);
        const RowVec y = row_load(u, place) + RowLanes(kJacobiWeight) * (row_load(inverse_diagonal, place) * defect);
        row_store(to, place, y);
        sum = sum + row_dot(goal, y);
    }
    return row_sum(sum);
}

}  // namespace nuno
