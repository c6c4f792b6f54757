// A vertex and a face, the unit of both tests of this folder.
#pragma once

#include <compare>
#include <cstdint>

namespace nuno {

struct VertexFace
{
    std::uint32_t vertex, face;
    auto operator<=>(const VertexFace&) const = default;
};

}  // namespace nuno
