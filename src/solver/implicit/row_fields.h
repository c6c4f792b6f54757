// Arrays of numbers, vectors and matrices for every vertex of a sheet, read sixteen at a time.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "solver/base/aligned_floats.h"
#include "solver/implicit/row_lanes.h"

namespace nuno {

// A number for every vertex, and so on.
using Field = AlignedFloats;

NUNO_WIDE_INLINE RowLanes row_load(const Field& a, std::size_t i) { return RowLanes(a.data() + i); }
NUNO_WIDE_INLINE void row_store(Field& a, std::size_t i, const RowLanes& value) { value.store(a.data() + i); }

struct Field3
{
    Field3() = default;
    explicit Field3(std::size_t size) : x(size), y(size), z(size) {}
    Field x, y, z;
};

inline glm::vec3 at(const Field3& a, std::size_t i) { return {a.x[i], a.y[i], a.z[i]}; }
inline void put(Field3& a, std::size_t i, const glm::vec3& value)
{
    a.x[i] = value.x;
    a.y[i] = value.y;
    a.z[i] = value.z;
}

NUNO_WIDE_INLINE RowVec row_load(const Field3& a, std::size_t i)
{
    return {row_load(a.x, i), row_load(a.y, i), row_load(a.z, i)};
}

NUNO_WIDE_INLINE void row_store(Field3& a, std::size_t i, const RowVec& value)
{
    row_store(a.x, i, value.x);
    row_store(a.y, i, value.y);
    row_store(a.z, i, value.z);
}

// A symmetric 3x3 matrix for every vertex: xx, xy, xz, yy, yz, zz.
struct Field6
{
    Field6() = default;
    explicit Field6(std::size_t size)
    {
        for (Field& field : part) field = Field(size);
    }
    Field part[6];
};

NUNO_WIDE_INLINE RowMatrix row_load(const Field6& a, std::size_t i)
{
    return {row_load(a.part[0], i), row_load(a.part[1], i), row_load(a.part[2], i),
            row_load(a.part[3], i), row_load(a.part[4], i), row_load(a.part[5], i)};
}

NUNO_WIDE_INLINE void row_store(Field6& a, std::size_t i, const RowMatrix& m)
{
    row_store(a.part[0], i, m.xx);
    row_store(a.part[1], i, m.xy);
    row_store(a.part[2], i, m.xz);
    row_store(a.part[3], i, m.yy);
    row_store(a.part[4], i, m.yz);
    row_store(a.part[5], i, m.zz);
}

}  // namespace nuno
