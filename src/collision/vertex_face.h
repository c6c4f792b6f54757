// A vertex and a face that it went through.
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
