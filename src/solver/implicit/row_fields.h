// Arrays of numbers, vectors and matrices for every vertex of a sheet, read sixteen at a time.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#include "solver/implicit/row_lanes.h"

namespace nuno {

// Zeroed floats at the start of a cache line.
class Field
{
  public:
    Field() = default;
    explicit Field(std::size_t size)
    {
        const std::size_t bytes = (size * sizeof(float) + 63) / 64 * 64;
        values_.reset(static_cast<float*>(std::aligned_alloc(64, bytes)));
        if (!values_) throw std::bad_alloc();
        std::memset(values_.get(), 0, bytes);
    }
    float* get() { return values_.get(); }
    const float* get() const { return values_.get(); }
    float& operator[](std::size_t i) { return values_.get()[i]; }
    float operator[](std::size_t i) const { return values_.get()[i]; }

  private:
    struct Free
    {
        void operator()(float* p) const { std::free(p); }
    };
    std::unique_ptr<float, Free> values_;
};

// A vector for every vertex.
struct Field3
{
    Field3() = default;
    explicit Field3(std::size_t size) : x(size), y(size), z(size) {}
    Field x, y, z;
};

NUNO_WIDE_INLINE RowVec row_load(const Field3& a, std::size_t i)
{
    return {row_load(a.x.get() + i), row_load(a.y.get() + i), row_load(a.z.get() + i)};
}

NUNO_WIDE_INLINE void row_store(Field3& a, std::size_t i, const RowVec& value)
{
    row_store(a.x.get() + i, value.x);
    row_store(a.y.get() + i, value.y);
    row_store(a.z.get() + i, value.z);
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
    return {row_load(a.part[0].get() + i), row_load(a.part[1].get() + i), row_load(a.part[2].get() + i),
            row_load(a.part[3].get() + i), row_load(a.part[4].get() + i), row_load(a.part[5].get() + i)};
}

NUNO_WIDE_INLINE void row_store(Field6& a, std::size_t i, const RowMatrix& m)
{
    row_store(a.part[0].get() + i, m.xx);
    row_store(a.part[1].get() + i, m.xy);
    row_store(a.part[2].get() + i, m.xz);
    row_store(a.part[3].get() + i, m.yy);
    row_store(a.part[4].get() + i, m.yz);
    row_store(a.part[5].get() + i, m.zz);
}

}  // namespace nuno
