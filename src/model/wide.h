// Many particles side by side: a float and a vec3 of kLanes lanes, with the operators that the shared formulas use.
// The compiler lowers them to whatever SIMD the target has; a lane computes what the scalar formula does, bit for bit.
#pragma once

#include <cmath>
#include <cstring>

// Wide values never cross a call (everything here is inlined), so the note on their calling convention does not apply.
#pragma GCC diagnostic ignored "-Wpsabi"

#define NUNO_WIDE_INLINE inline __attribute__((always_inline))

// One clone per instruction set, chosen when the program starts. Sanitizers cannot run the chooser, clang 14 lacks the
// names.
#if defined(NUNO_SANITIZED) || defined(__clang__)
#define NUNO_SIMD_CLONES
#else
#define NUNO_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif

namespace nuno {

constexpr int kLanes = 8;

struct WideFloat
{
    typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float))));
    Lanes lanes;

    WideFloat() = default;
    NUNO_WIDE_INLINE explicit WideFloat(float a) : lanes(a - Lanes{}) {}
    NUNO_WIDE_INLINE explicit WideFloat(const Lanes& a) : lanes(a) {}
    NUNO_WIDE_INLINE explicit WideFloat(const float* from) { std::memcpy(&lanes, from, sizeof lanes); }
    NUNO_WIDE_INLINE void store(float* to) const { std::memcpy(to, &lanes, sizeof lanes); }
};

NUNO_WIDE_INLINE WideFloat operator+(WideFloat a, WideFloat b) { return WideFloat(a.lanes + b.lanes); }
NUNO_WIDE_INLINE WideFloat operator-(WideFloat a, WideFloat b) { return WideFloat(a.lanes - b.lanes); }
NUNO_WIDE_INLINE WideFloat operator*(WideFloat a, WideFloat b) { return WideFloat(a.lanes * b.lanes); }
NUNO_WIDE_INLINE WideFloat operator/(WideFloat a, WideFloat b) { return WideFloat(a.lanes / b.lanes); }
NUNO_WIDE_INLINE WideFloat operator-(WideFloat a) { return WideFloat(-a.lanes); }
NUNO_WIDE_INLINE WideFloat max_real(WideFloat a, WideFloat b)
{
    return WideFloat(a.lanes > b.lanes ? a.lanes : b.lanes);
}

NUNO_WIDE_INLINE WideFloat sqrt_real(WideFloat a)
{
    WideFloat root;
    for (int i = 0; i < kLanes; ++i) root.lanes[i] = std::sqrt(a.lanes[i]);
    return root;
}

NUNO_WIDE_INLINE WideFloat select_positive(WideFloat condition, WideFloat a, WideFloat b)
{
    return WideFloat(condition.lanes > WideFloat::Lanes{} ? a.lanes : b.lanes);
}

struct WideVec3
{
    WideFloat x, y, z;
    WideVec3() = default;
    NUNO_WIDE_INLINE WideVec3(WideFloat x_, WideFloat y_, WideFloat z_) : x(x_), y(y_), z(z_) {}
    NUNO_WIDE_INLINE explicit WideVec3(float a) : x(a), y(a), z(a) {}
};

NUNO_WIDE_INLINE WideVec3 operator+(WideVec3 a, WideVec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
NUNO_WIDE_INLINE WideVec3 operator-(WideVec3 a, WideVec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
NUNO_WIDE_INLINE WideVec3 operator*(WideFloat a, WideVec3 b) { return {a * b.x, a * b.y, a * b.z}; }
NUNO_WIDE_INLINE WideVec3 operator/(WideVec3 a, WideFloat b) { return {a.x / b, a.y / b, a.z / b}; }

NUNO_WIDE_INLINE WideVec3 select_positive(WideFloat condition, WideVec3 a, WideVec3 b)
{
    return {select_positive(condition, a.x, b.x), select_positive(condition, a.y, b.y),
            select_positive(condition, a.z, b.z)};
}

}  // namespace nuno
