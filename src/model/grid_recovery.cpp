// From triangles to cells, from cells to rows.
#include "model/grid_recovery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Cell = std::array<std::uint32_t, 4>;  // in turn around it

constexpr float kAlike = 1e-3f;

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The corner of a face that is opposite to its longest side.
int right_angle(const TriangleMesh& mesh, const glm::uvec3& face)
{
    std::array<float, 3> side{};  // opposite to each corner
    for (int k = 0; k < 3; ++k)
        side[std::size_t(k)] = glm::distance(mesh.positions[face[(k + 1) % 3]], mesh.positions[face[(k + 2) % 3]]);
    return static_cast<int>(std::max_element(side.begin(), side.end()) - side.begin());
}

// Two faces with the same longest side are a cell; nothing if any face is left over.
std::optional<std::vector<Cell>> cells_of(const TriangleMesh& mesh)
{
    std::map<Edge, std::vector<glm::uvec3>> by_diagonal;  // faces from the right angle on
    for (const glm::uvec3& face : mesh.faces) {
        const int k = right_angle(mesh, face);
        const glm::uvec3 turned(face[k], face[(k + 1) % 3], face[(k + 2) % 3]);
        by_diagonal[edge_of(turned[1], turned[2])].push_back(turned);
    }
    std::vector<Cell> cells;
    for (const auto& [diagonal, faces] : by_diagonal) {
        if (faces.size() != 2 || faces[0][0] == faces[1][0]) return std::nullopt;
        cells.push_back({faces[0][0], faces[0][1], faces[1][0], faces[0][2]});
    }
    return cells;
}

// The cells of a mesh by their sides.
class CellWalk
{
  public:
    CellWalk(const std::vector<Cell>& cells, std::size_t vertex_count) : cells_(cells), neighbours_(vertex_count)
    {
        for (std::uint32_t c = 0; c < cells.size(); ++c)
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t a = cells[c][k], b = cells[c][(k + 1) % 4];
                std::vector<std::uint32_t>& beside = beside_[edge_of(a, b)];
                if (beside.empty()) {
                    neighbours_[a].push_back(b);
                    neighbours_[b].push_back(a);
                }
                beside.push_back(c);
            }
    }

    const std::vector<std::uint32_t>& neighbours(std::uint32_t v) const { return neighbours_[v]; }
    bool is_corner(std::uint32_t v) const { return neighbours_[v].size() == 2; }
    bool on_rim(std::uint32_t a, std::uint32_t b) const
    {
        const auto found = beside_.find(edge_of(a, b));
        return found != beside_.end() && found->second.size() == 1;
    }

    // The vertex of the cell with the corner `b` between `a` and `c` that is opposite to b.
    std::optional<std::uint32_t> opposite(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        const auto found = beside_.find(edge_of(a, b));
        if (found == beside_.end()) return std::nullopt;
        for (const std::uint32_t cell : found->second)
            for (std::size_t k = 0; k < 4; ++k) {
                const Cell& v = cells_[cell];
                const std::uint32_t before = v[(k + 3) % 4], after = v[(k + 1) % 4];
                if (v[k] == b && ((before == a && after == c) || (before == c && after == a))) return v[(k + 2) % 4];
            }
        return std::nullopt;
    }

  private:
    const std::vector<Cell>& cells_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
    std::map<Edge, std::vector<std::uint32_t>> beside_;  // cells of each side
};

// Along the rim from a corner by way of `next` to the corner after it.
std::vector<std::uint32_t> rim_from(const CellWalk& walk, std::uint32_t corner, std::uint32_t next, std::size_t most)
{
    std::vector<std::uint32_t> row{corner, next};
    while (!walk.is_corner(row.back()) && row.size() <= most) {
        const std::uint32_t at = row.back(), before = row[row.size() - 2];
        const auto& around = walk.neighbours(at);
        const auto found = std::find_if(around.begin(), around.end(),
                                        [&](std::uint32_t v) { return v != before && walk.on_rim(at, v); });
        if (found == around.end()) return {};
        row.push_back(*found);
    }
    return row;
}

// Vertices row by row, from one side of the rim to the other; nothing where cells are not rows and columns.
std::optional<RecoveredGrid> rows_of(const CellWalk& walk, std::size_t vertex_count)
{
    std::uint32_t corner = 0;
    while (corner < vertex_count && !walk.is_corner(corner)) ++corner;
    if (corner == vertex_count) return std::nullopt;
    const std::vector<std::uint32_t> first = rim_from(walk, corner, walk.neighbours(corner)[0], vertex_count);
    const std::vector<std::uint32_t> side = rim_from(walk, corner, walk.neighbours(corner)[1], vertex_count);
    if (first.empty() || side.empty() || first.size() * side.size() != vertex_count) return std::nullopt;

    RecoveredGrid grid{static_cast<int>(first.size()), static_cast<int>(side.size()), first};
    for (std::size_t j = 1; j < side.size(); ++j) {
        grid.order.push_back(side[j]);
        for (std::size_t i = 1; i < first.size(); ++i) {
            const std::size_t above = (j - 1) * first.size() + i;
            const auto next = walk.opposite(grid.order.back(), grid.order[above - 1], grid.order[above]);
            if (!next) return std::nullopt;
            grid.order.push_back(*next);
        }
    }
    std::vector<bool> seen(vertex_count);
    for (const std::uint32_t v : grid.order) {
        if (seen[v]) return std::nullopt;
        seen[v] = true;
    }
    return grid;
}

bool cells_are_alike(const TriangleMesh& mesh, const RecoveredGrid& grid)
{
    std::array<float, 3> first{};  // across, down, diagonal
    const auto at = [&](int i, int j) {
        return mesh.positions[grid.order[static_cast<std::size_t>(j * grid.columns + i)]];
    };
    const auto like_first = [&](std::size_t kind, glm::vec3 a, glm::vec3 b) {
        const float length = glm::distance(a, b);
        if (first[kind] == 0) first[kind] = length;
        return std::abs(length - first[kind]) <= kAlike * first[kind];
    };
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool right = i + 1 < grid.columns, below = j + 1 < grid.rows;
            if (right && !like_first(0, at(i, j), at(i + 1, j))) return false;
            if (below && !like_first(1, at(i, j), at(i, j + 1))) return false;
            if (right && below && !like_first(2, at(i, j), at(i + 1, j + 1))) return false;
            if (right && below && !like_first(2, at(i + 1, j), at(i, j + 1))) return false;
        }
    return true;
}

RecoveredGrid transposed(const RecoveredGrid& grid)
{
    RecoveredGrid result{grid.rows, grid.columns, {}};
    for (int j = 0; j < result.rows; ++j)
        for (int i = 0; i < result.columns; ++i)
            result.order.push_back(grid.order[static_cast<std::size_t>(i * grid.columns + j)]);
    return result;
}

RecoveredGrid flipped(const RecoveredGrid& grid, bool across, bool down)
{
    RecoveredGrid result{grid.columns, grid.rows, {}};
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const int i1 = across ? grid.columns - 1 - i : i, j1 = down ? grid.rows - 1 - j : j;
            result.order.push_back(grid.order[static_cast<std::size_t>(j1 * grid.columns + i1)]);
        }
    return result;
}

// How well rows and columns run the way that is asked for.
float fit(const TriangleMesh& mesh, const RecoveredGrid& grid)
{
    const std::uint32_t origin = grid.order[0], right = grid.order[std::size_t(grid.columns) - 1];
    const std::uint32_t below = grid.order[grid.order.size() - std::size_t(grid.columns)];
    if (mesh.uvs.size() == mesh.positions.size() &&
        (mesh.uvs[right] != mesh.uvs[origin] && mesh.uvs[below] != mesh.uvs[origin]))
        return (mesh.uvs[right].x - mesh.uvs[origin].x) + (mesh.uvs[origin].y - mesh.uvs[below].y);
    const glm::vec3 across = glm::normalize(mesh.positions[right] - mesh.positions[origin]);
    const glm::vec3 down = glm::normalize(mesh.positions[below] - mesh.positions[origin]);
    return across.x - down.y + down.z / 2;
}

}  // namespace

std::optional<RecoveredGrid> recover_grid(const TriangleMesh& mesh)
{
    const auto cells = cells_of(mesh);
    if (!cells || cells->empty()) return std::nullopt;
    const CellWalk walk(*cells, mesh.positions.size());
    const auto grid = rows_of(walk, mesh.positions.size());
    if (!grid || !cells_are_alike(mesh, *grid)) return std::nullopt;
    RecoveredGrid best = *grid;
    for (const RecoveredGrid& turned : {*grid, transposed(*grid)})
        for (const bool across : {false, true})
            for (const bool down : {false, true}) {
                const RecoveredGrid candidate = flipped(turned, across, down);
                if (fit(mesh, candidate) > fit(mesh, best)) best = candidate;
            }
    return best;
}

}  // namespace nuno
