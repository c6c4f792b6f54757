// A double as an integer times a power of two.
#pragma once

#include <bit>
#include <cstdint>

namespace nuno {

struct BinaryParts
{
    std::int64_t bits;  // odd, or 0
    int exponent;
};

// bits * 2^exponent = value, which must be finite.
inline BinaryParts binary_parts(double value)
{
    const auto word = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>(word >> 52 & 0x7ff);
    const std::uint64_t fraction = word & 0xfffffffffffff;
    const std::uint64_t magnitude = biased == 0 ? fraction : fraction | 0x10000000000000;
    if (magnitude == 0) return {0, 0};
    const int zeros = std::countr_zero(magnitude);
    const auto bits = static_cast<std::int64_t>(magnitude >> zeros);
    return {value < 0 ? -bits : bits, (biased == 0 ? 1 : biased) - 1075 + zeros};
}

}  // namespace nuno
