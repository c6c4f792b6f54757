// Four floats side by side, which the compiler lowers to whatever SIMD the target has.
#pragma once

#include <cstring>

#include <glm/vec4.hpp>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace nuno {

typedef float Float4 __attribute__((vector_size(16)));
typedef int Int4 __attribute__((vector_size(16)));  // of a comparison: -1 where it holds, else 0

inline Float4 all_lanes(float a) { return Float4{a, a, a, a}; }
inline Float4 lanes_of(const glm::vec4& a)
{
    Float4 lanes;
    std::memcpy(&lanes, &a, sizeof lanes);
    return lanes;
}
inline Float4 lesser(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 greater(Float4 a, Float4 b) { return a > b ? a : b; }

// Bit i is set where lane i holds.
inline unsigned lane_bits(Int4 mask)
{
#if defined(__SSE__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    return (mask[0] & 1u) | (mask[1] & 2u) | (mask[2] & 4u) | (mask[3] & 8u);
#endif
}

}  // namespace nuno
