// Which vertices springs join.
#include "model/springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// One half of the seed's 12 neighbours: every spring is met once, from the end that comes first in its direction.
struct Offset
{
    int i, j;
    SpringKind kind;
};
constexpr std::array<Offset, 6> kOffsets{{{1, 0, SpringKind::weft},
                                          {0, 1, SpringKind::warp},
                                          {1, 1, SpringKind::shear},
                                          {-1, 1, SpringKind::shear},
                                          {2, 0, SpringKind::bend_weft},
                                          {0, 2, SpringKind::bend_warp}}};

// The springs of a grid in the order of append_grid_springs, by place.
class GridSprings
{
  public:
    GridSprings(std::span<Spring> springs, int columns, int rows) : springs_(springs), columns_(columns)
    {
        for (std::size_t k = 0; k < kOffsets.size(); ++k)
            first_[k + 1] = first_[k] + std::max(width(k), 0) * std::max(rows - kOffsets[k].j, 0);
    }

    // The spring of offset k that starts at column i, row j.
    Spring& at(std::size_t k, int i, int j)
    {
        const int first_column = std::max(-kOffsets[k].i, 0);
        return springs_[static_cast<std::size_t>(first_[k] + j * width(k) + i - first_column)];
    }

  private:
    int width(std::size_t k) const { return columns_ - std::abs(kOffsets[k].i); }

    std::span<Spring> springs_;
    int columns_;
    std::array<int, kOffsets.size() + 1> first_{};
};

enum : std::size_t
{
    kWeft,
    kWarp,
    kDown,  // the diagonal to (i + 1, j + 1)
    kUp,    // the diagonal to (i - 1, j + 1)
    kTwoWeft,
    kTwoWarp
};

constexpr glm::vec3 kWarpOnly{1, 0, 0}, kWeftOnly{0, 1, 0}, kTwistOnly{0, 0, 1};

void add_grid_plate(GridSprings& springs, int columns, int rows, float dx, float dy)
{
    // (1, -2, 1) along a row: weights 2, 2, -1. At the rim only half a cell bends with it.
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i + 2 < columns; ++i) {
            const glm::vec3 w = kWeftOnly * ((j == 0 || j == rows - 1 ? 0.5f : 1.0f) * dy / (dx * dx * dx));
            springs.at(kWeft, i, j).plate += 2.0f * w;
            springs.at(kWeft, i + 1, j).plate += 2.0f * w;
            springs.at(kTwoWeft, i, j).plate -= w;
        }
    for (int j = 0; j + 2 < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const glm::vec3 w = kWarpOnly * ((i == 0 || i == columns - 1 ? 0.5f : 1.0f) * dx / (dy * dy * dy));
            springs.at(kWarp, i, j).plate += 2.0f * w;
            springs.at(kWarp, i, j + 1).plate += 2.0f * w;
            springs.at(kTwoWarp, i, j).plate -= w;
        }
    // (1, -1, -1, 1) on a cell: its sides 1, its diagonals -1.
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const glm::vec3 w = kTwistOnly / (dx * dy);
            springs.at(kWeft, i, j).plate += w;
            springs.at(kWeft, i, j + 1).plate += w;
            springs.at(kWarp, i, j).plate += w;
            springs.at(kWarp, i + 1, j).plate += w;
            springs.at(kDown, i, j).plate -= w;
            springs.at(kUp, i + 1, j).plate -= w;
        }
}

// Angle weights of the corner at `corner`: cot of the angle there.
float cotangent(glm::vec3 corner, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 u = a - corner, v = b - corner;
    return glm::dot(u, v) / std::max(glm::length(glm::cross(u, v)), 1e-20f);
}

float warp_share_of(glm::vec3 direction, glm::vec3 warp)
{
    const float cosine = glm::dot(glm::normalize(direction), warp);
    return std::min(cosine * cosine, 1.0f);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The corner opposite to an edge, and its face.
struct Opposite
{
    std::uint32_t corner, face;
};

// Weights of a hinge, products of its cotangents, are as far off by rounding as their sum is worth in a bend of a radian
// where a cotangent squared is the 2^24 of a float: a form that can be below 0, and without end in thinner faces.
constexpr float kLargestCotangent = 4096;

// A hinge: edge (v0, v1) between the corners v2 and v3.
void add_hinge_plate(std::map<Edge, Spring*>& edges, Spring& hinge, std::span<const glm::vec3> positions,
                     std::array<std::uint32_t, 4> v, float warp_share)
{
    const auto at = [&](int k) { return positions[v[static_cast<std::size_t>(k)]]; };
    const float cot02 = cotangent(at(0), at(1), at(2)), cot03 = cotangent(at(0), at(1), at(3));
    const float cot12 = cotangent(at(1), at(0), at(2)), cot13 = cotangent(at(1), at(0), at(3));
    const std::array<float, 4> c{cot12 + cot13, cot02 + cot03, -cot02 - cot12, -cot03 - cot13};
    if (std::any_of(c.begin(), c.end(), [](float sum) { return std::abs(sum) > kLargestCotangent; })) return;
    const float area = (glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) +
                        glm::length(glm::cross(at(1) - at(0), at(3) - at(0)))) /
                       2;
    // D across the edge, in the direction whose squared cosine to the warp is 1 - warp_share.
    const float s = warp_share, w = 1 - s;
    const glm::vec3 direction = kWarpOnly * (w * w) + kWeftOnly * (s * s) + kTwistOnly * (w * s);
    for (std::size_t p = 0; p < 4; ++p)
        for (std::size_t q = p + 1; q < 4; ++q) {
            Spring& spring = p == 2 ? hinge : *edges.at(edge_of(v[p], v[q]));
            spring.plate -= direction * (c[p] * c[q] / area);
        }
}

}  // namespace

void append_grid_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions, const Sheet& sheet)
{
    const std::size_t first = springs.size();
    const int columns = sheet.columns, rows = sheet.rows;
    for (const Offset& offset : kOffsets)
        for (int j = 0; j + offset.j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const int i1 = i + offset.i, j1 = j + offset.j;
                if (i1 < 0 || i1 >= columns) continue;
                Spring spring{sheet.grid_vertex(i, j), sheet.grid_vertex(i1, j1), 0, offset.kind};
                spring.rest_length = glm::distance(positions[spring.a], positions[spring.b]);
                const bool rim =
                    (offset.i == 0 && (i == 0 || i == columns - 1)) || (offset.j == 0 && (j == 0 || j == rows - 1));
                spring.share = rim ? 0.5f : 1.0f;
                springs.push_back(spring);
            }
    const float dx = glm::distance(positions[sheet.grid_vertex(0, 0)], positions[sheet.grid_vertex(1, 0)]);
    const float dy = glm::distance(positions[sheet.grid_vertex(0, 0)], positions[sheet.grid_vertex(0, 1)]);
    const std::span<Spring> added = std::span<Spring>(springs).subspan(first);
    for (Spring& spring : added) spring.cell_ratio = dy / dx;
    GridSprings grid(added, columns, rows);
    add_grid_plate(grid, columns, rows, dx, dy);
}

void append_mesh_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions,
                         std::span<const glm::uvec3> faces, std::span<const glm::vec3> warps)
{
    // Ordered maps keep the springs in a fixed order.
    std::map<Edge, std::vector<Opposite>> opposite;
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            opposite[edge_of(faces[f][k], faces[f][(k + 1) % 3])].push_back({faces[f][(k + 2) % 3], f});

    const std::size_t first = springs.size();
    for (const auto& [edge, sides] : opposite) {
        const glm::vec3 along = positions[edge.second] - positions[edge.first];
        Spring spring{edge.first, edge.second, glm::length(along), SpringKind::edge, 0};
        for (const Opposite& side : sides) {
            const float area = glm::length(glm::cross(along, positions[side.corner] - positions[edge.first])) / 2;
            spring.share += area / (spring.rest_length * spring.rest_length);
            spring.warp_share += warp_share_of(along, warps[side.face]) / static_cast<float>(sides.size());
        }
        springs.push_back(spring);
    }
    for (const auto& [edge, sides] : opposite)
        if (sides.size() == 2 && sides[0].corner != sides[1].corner)
            springs.push_back({sides[0].corner, sides[1].corner,
                               glm::distance(positions[sides[0].corner], positions[sides[1].corner]),
                               SpringKind::hinge});

    std::map<Edge, Spring*> edges;
    std::size_t next = first;
    for (const auto& [edge, sides] : opposite) edges[edge] = &springs[next++];
    for (const auto& [edge, sides] : opposite)
        if (sides.size() == 2 && sides[0].corner != sides[1].corner)
            add_hinge_plate(edges, springs[next++], positions,
                            {edge.first, edge.second, sides[0].corner, sides[1].corner}, edges[edge]->warp_share);
}

glm::vec3 face_warp(const TriangleMesh& mesh, const glm::uvec3& face)
{
    const glm::vec3 a = mesh.positions[face[1]] - mesh.positions[face[0]];
    const glm::vec3 b = mesh.positions[face[2]] - mesh.positions[face[0]];
    glm::vec3 warp = glm::length(a) > glm::length(b) ? a : b;
    if (mesh.uvs.size() == mesh.positions.size()) {
        const glm::vec2 s = mesh.uvs[face[1]] - mesh.uvs[face[0]], t = mesh.uvs[face[2]] - mesh.uvs[face[0]];
        const float determinant = s.x * t.y - t.x * s.y;
        // dx/dv of the map from the texture to the face.
        const glm::vec3 along_v = (b * s.x - a * t.x) * (determinant < 0 ? -1.0f : 1.0f);
        if (determinant != 0 && glm::length(along_v) > 0) warp = along_v;
    }
    return glm::normalize(warp);
}

}  // namespace nuno
