// Many particles side by side: a float and a vec3 of kCount lanes, with the operators that the shared formulas use.
// The compiler lowers them to whatever SIMD the target has; a lane computes what the scalar formula does, bit for bit.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

// Wide values cross no call between instruction sets, so the note on their calling convention does not apply.
#pragma GCC diagnostic ignored "-Wpsabi"

#define NUNO_WIDE_INLINE inline __attribute__((always_inline))
// After the parameters of a lambda in a kernel: by itself it would be compiled for no instruction set but the default.
#define NUNO_WIDE_LAMBDA __attribute__((always_inline))

// One clone per instruction set, chosen when the program starts. Sanitizers cannot run the chooser, clang 14 lacks the
// names.
#if defined(NUNO_SANITIZED) || defined(__clang__)
#define NUNO_SIMD_CLONES
#else
#define NUNO_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif

namespace nuno {

// Lanes of the kernels whose vectors are the same on every instruction set.
constexpr int kLanes = 8;

template <int kCount>
struct Wide
{
    typedef float Lanes __attribute__((vector_size(kCount * sizeof(float))));
    typedef std::uint32_t Bits __attribute__((vector_size(kCount * sizeof(float))));
    Lanes lanes;

    Wide() = default;
    // GCC 12 spreads an array by one instruction, but the scalar of a vector expression lane by lane.
    NUNO_WIDE_INLINE explicit Wide(float a)
    {
        float values[kCount];
        for (float& value : values) value = a;
        std::memcpy(&lanes, values, sizeof lanes);
    }
    NUNO_WIDE_INLINE explicit Wide(const Lanes& a) : lanes(a) {}
    NUNO_WIDE_INLINE explicit Wide(const float* from) { std::memcpy(&lanes, from, sizeof lanes); }
    NUNO_WIDE_INLINE void store(float* to) const { std::memcpy(to, &lanes, sizeof lanes); }

    // Hidden friends, so that a template argument is deduced from the operands.
    friend NUNO_WIDE_INLINE Wide operator+(Wide a, Wide b) { return Wide(a.lanes + b.lanes); }
    friend NUNO_WIDE_INLINE Wide operator-(Wide a, Wide b) { return Wide(a.lanes - b.lanes); }
    friend NUNO_WIDE_INLINE Wide operator*(Wide a, Wide b) { return Wide(a.lanes * b.lanes); }
    friend NUNO_WIDE_INLINE Wide operator/(Wide a, Wide b) { return Wide(a.lanes / b.lanes); }
    friend NUNO_WIDE_INLINE Wide operator-(Wide a) { return Wide(-a.lanes); }
    friend NUNO_WIDE_INLINE Wide max_real(Wide a, Wide b) { return Wide(a.lanes > b.lanes ? a.lanes : b.lanes); }

    friend NUNO_WIDE_INLINE Wide min_real(Wide a, Wide b) { return Wide(a.lanes < b.lanes ? a.lanes : b.lanes); }

    friend NUNO_WIDE_INLINE Wide floor_real(Wide a)
    {
        float values[kCount];
        a.store(values);
        for (int i = 0; i < kCount; ++i) values[i] = std::floor(values[i]);
        return Wide(values);
    }

    friend NUNO_WIDE_INLINE Wide sqrt_real(Wide a)
    {
        float values[kCount];
        a.store(values);
        for (int i = 0; i < kCount; ++i) values[i] = std::sqrt(values[i]);
        return Wide(values);
    }

    // By bits: GCC 12 takes a choice among choices by vectors' ?: apart into lanes.
    static NUNO_WIDE_INLINE Wide chosen(const Bits& mask, Wide a, Wide b)
    {
        Bits ours, others;
        std::memcpy(&ours, &a.lanes, sizeof ours);
        std::memcpy(&others, &b.lanes, sizeof others);
        ours = (ours & mask) | (others & ~mask);
        std::memcpy(&a.lanes, &ours, sizeof ours);
        return a;
    }

    friend NUNO_WIDE_INLINE Wide select_positive(Wide condition, Wide a, Wide b)
    {
        return chosen(Bits(condition.lanes > Lanes{}), a, b);
    }

    // The bits of whole numbers, and the other way for such below 2^24 (shaders/shared/gust.h).
    friend NUNO_WIDE_INLINE Bits bits_of_whole(Wide a)
    {
        float values[kCount];
        a.store(values);
        std::uint32_t whole[kCount];
        for (int i = 0; i < kCount; ++i) whole[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(values[i]));
        Bits bits;
        std::memcpy(&bits, whole, sizeof bits);
        return bits;
    }

    static NUNO_WIDE_INLINE Wide of_bits(Bits a)
    {
        std::uint32_t whole[kCount];
        std::memcpy(whole, &a, sizeof whole);
        float values[kCount];
        for (int i = 0; i < kCount; ++i) values[i] = static_cast<float>(static_cast<std::int32_t>(whole[i]));
        return Wide(values);
    }

    // The float whose bits are `minuend` less half of the bits of a (shaders/shared/vector.h).
    friend NUNO_WIDE_INLINE Wide halved_bits_from(std::uint32_t minuend, Wide a)
    {
        Bits bits;
        std::memcpy(&bits, &a.lanes, sizeof bits);
        bits = minuend - (bits >> 1);
        Wide result;
        std::memcpy(&result.lanes, &bits, sizeof bits);
        return result;
    }
};

template <int kCount>
struct WideVec
{
    using Real = Wide<kCount>;
    Real x, y, z;
    WideVec() = default;
    NUNO_WIDE_INLINE WideVec(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    NUNO_WIDE_INLINE explicit WideVec(float a) : x(a), y(a), z(a) {}

    friend NUNO_WIDE_INLINE WideVec operator+(WideVec a, WideVec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend NUNO_WIDE_INLINE WideVec operator-(WideVec a, WideVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend NUNO_WIDE_INLINE WideVec operator*(Real a, WideVec b) { return {a * b.x, a * b.y, a * b.z}; }
    friend NUNO_WIDE_INLINE WideVec operator/(WideVec a, Real b) { return {a.x / b, a.y / b, a.z / b}; }

    friend NUNO_WIDE_INLINE WideVec select_positive(Real condition, WideVec a, WideVec b)
    {
        return {select_positive(condition, a.x, b.x), select_positive(condition, a.y, b.y),
                select_positive(condition, a.z, b.z)};
    }
};

using WideFloat = Wide<kLanes>;
using WideVec3 = WideVec<kLanes>;

}  // namespace nuno
