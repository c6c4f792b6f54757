// Greedy pairing by edges; median splits.
#include "collision/tree/cell_pairing.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A face's edge opposite to one corner, ends in ascending order.
struct FaceEdge
{
    std::uint32_t a, b, face;
    int corner;
    float length_sq;
};

std::vector<FaceEdge> edges_by_ends(const FaceRun& run)
{
    std::vector<FaceEdge> edges;
    edges.reserve(3 * std::size_t(run.face_count));
    for (std::uint32_t f = run.first_face; f < run.first_face + run.face_count; ++f)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t p = run.faces[f][(corner + 1) % 3], q = run.faces[f][(corner + 2) % 3];
            const glm::vec3 side = run.rest_positions[p] - run.rest_positions[q];
            edges.push_back({std::min(p, q), std::max(p, q), f, corner, glm::dot(side, side)});
        }
    std::sort(edges.begin(), edges.end(), [](const FaceEdge& x, const FaceEdge& y) {
        return std::tie(x.a, x.b, x.face, x.corner) < std::tie(y.a, y.b, y.face, y.corner);
    });
    return edges;
}

// Two faces that could be one cell.
struct Match
{
    std::uint32_t first, second;  // in the list of edges
    float length_sq;
};

std::vector<Match> matches_of(const std::vector<FaceEdge>& edges)
{
    std::vector<Match> matches;
    for (std::uint32_t e = 0; e + 1 < edges.size(); ++e) {
        const FaceEdge &x = edges[e], &y = edges[e + 1];
        if (x.a == y.a && x.b == y.b && x.face != y.face) matches.push_back({e, e + 1, x.length_sq});
    }
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& x, const Match& y) { return x.length_sq > y.length_sq; });
    return matches;
}

int longest_axis(std::span<const std::uint32_t> order, std::span<const glm::vec3> centres)
{
    glm::vec3 lo(kInfinity), hi(-kInfinity);
    for (const std::uint32_t cell : order) {
        lo = glm::min(lo, centres[cell]);
        hi = glm::max(hi, centres[cell]);
    }
    const glm::vec3 extent = hi - lo;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

// Splits `order` at the multiple of `capacity`, a power of 4, that is nearest to its middle, and each part again.
void split(std::span<std::uint32_t> order, std::size_t capacity, std::span<const glm::vec3> centres)
{
    while (capacity >= order.size() && capacity > 1) capacity /= 4;
    if (order.size() <= 1) return;
    const std::size_t parts = (order.size() + capacity - 1) / capacity, middle = capacity * ((parts + 1) / 2);
    const int axis = longest_axis(order, centres);
    std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(middle), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
                     });
    split(order.first(middle), capacity, centres);
    split(order.subspan(middle), capacity, centres);
}

}  // namespace

std::vector<Cell> pair_faces(const FaceRun& run)
{
    const std::vector<FaceEdge> edges = edges_by_ends(run);
    std::vector<bool> taken(run.face_count);
    std::vector<Cell> cells;
    for (const Match& match : matches_of(edges)) {
        const FaceEdge &x = edges[match.first], &y = edges[match.second];
        if (taken[x.face - run.first_face] || taken[y.face - run.first_face]) continue;
        taken[x.face - run.first_face] = taken[y.face - run.first_face] = true;
        cells.push_back(
            Cell::of_two({x.a, x.b, run.faces[x.face][x.corner], run.faces[y.face][y.corner]}, x.face, y.face));
    }
    for (std::uint32_t f = 0; f < run.face_count; ++f) {
        const glm::uvec3 face = run.faces[run.first_face + f];
        if (!taken[f]) cells.push_back(Cell::of_one({face.x, face.y, face.z}, run.first_face + f));
    }
    return cells;
}

void order_cells(std::vector<Cell>& cells, std::span<const glm::vec3> rest_positions)
{
    std::vector<glm::vec3> centres;
    std::vector<std::uint32_t> order;
    for (const Cell& cell : cells) {
        glm::vec3 sum(0);
        for (const std::uint32_t v : cell.vertex) sum += rest_positions[v];
        centres.push_back(sum);
        order.push_back(static_cast<std::uint32_t>(order.size()));
    }
    std::size_t capacity = 1;
    while (capacity < cells.size()) capacity *= 4;
    split(order, capacity, centres);
    std::vector<Cell> ordered;
    for (const std::uint32_t cell : order) ordered.push_back(cells[cell]);
    cells = std::move(ordered);
}

}  // namespace nuno
