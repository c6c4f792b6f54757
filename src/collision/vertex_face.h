// A vertex and a face, the unit of both tests of this folder.
#pragma once

#include <cstdint>

namespace nuno {

struct VertexFace
{
    std::uint32_t vertex, face;
    bool operator==(const VertexFace&) const = default;
    bool operator<(const VertexFace& other) const
    {
        return vertex != other.vertex ? vertex < other.vertex : face < other.face;
    }
};

}  // namespace nuno
