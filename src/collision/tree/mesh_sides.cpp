// Sides with the same two ends, found by sorting.
#include "collision/tree/mesh_sides.h"

#include <algorithm>
#include <utility>

namespace nuno {
namespace {

struct Side
{
    std::uint32_t low, high;  // ends
    std::uint32_t face, corner;
    bool is_upwards;  // from low to high
};

std::vector<Side> sides_by_ends(std::span<const glm::uvec3> faces)
{
    std::vector<Side> sides;
    sides.reserve(3 * faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = faces[f][k], b = faces[f][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), f, static_cast<std::uint32_t>(k), a < b});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    return sides;
}

}  // namespace

MeshSides sides_of(std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
{
    MeshSides mesh;
    mesh.across.assign(faces.size(), {kOddSide, kOddSide, kOddSide});
    mesh.rim_next.assign(vertex_count, kNoVertex);
    std::vector<bool> has_two_rims(vertex_count);
    const std::vector<Side> sides = sides_by_ends(faces);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        const Side& one = sides[begin];
        while (end < sides.size() && sides[end].low == one.low && sides[end].high == one.high) ++end;
        if (end - begin == 1) {
            mesh.across[one.face][one.corner] = kNoFace;
            const std::uint32_t from = one.is_upwards ? one.low : one.high, to = one.is_upwards ? one.high : one.low;
            if (mesh.rim_next[from] != kNoVertex) has_two_rims[from] = true;
            mesh.rim_next[from] = to;
        } else if (end - begin == 2 && sides[begin + 1].is_upwards != one.is_upwards) {
            const Side& other = sides[begin + 1];
            mesh.across[one.face][one.corner] = other.face;
            mesh.across[other.face][other.corner] = one.face;
        }
    }
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        if (has_two_rims[v]) mesh.rim_next[v] = kNoVertex;
    return mesh;
}

}  // namespace nuno
