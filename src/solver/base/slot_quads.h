// Tables of slots as kernels read them, four slots a texel.
#pragma once

#include <cstddef>
#include <vector>

namespace nuno {

// Entry (slot, vertex) of `slots` is at slot * vertex_count + vertex, slots a multiple of 4. Texel (quad, vertex) of
// the result is at quad * vertex_count + vertex, so that neighbouring invocations read neighbouring texels.
template <class To, class From>
std::vector<To> in_quads(const std::vector<From>& slots, std::size_t vertex_count)
{
    std::vector<To> quads(slots.size());
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const std::size_t slot = i / vertex_count, vertex = i % vertex_count;
        quads[((slot / 4) * vertex_count + vertex) * 4 + slot % 4] = static_cast<To>(slots[i]);
    }
    return quads;
}

}  // namespace nuno
