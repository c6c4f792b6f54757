// Which vertices springs join.
#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "model/spring_table.h"

namespace nuno {

void append_grid_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions, std::uint32_t first,
                         int columns, int rows)
{
    // One half of the seed's 12 neighbours: every spring is met once, from the end that comes first in this list's
    // direction.
    struct Offset
    {
        int i, j;
        SpringKind kind;
    };
    constexpr Offset offsets[] = {{1, 0, SpringKind::structural}, {0, 1, SpringKind::structural},
                                  {1, 1, SpringKind::shear},      {-1, 1, SpringKind::shear},
                                  {2, 0, SpringKind::bend},       {0, 2, SpringKind::bend}};
    for (const Offset& offset : offsets) {
        for (int j = 0; j + offset.j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const int i1 = i + offset.i;
                if (i1 < 0 || i1 >= columns) continue;
                const auto a = first + static_cast<std::uint32_t>(j * columns + i);
                const auto b = first + static_cast<std::uint32_t>((j + offset.j) * columns + i1);
                springs.push_back({a, b, glm::distance(positions[a], positions[b]), offset.kind});
            }
        }
    }
}

void append_mesh_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions,
                         std::span<const glm::uvec3> faces)
{
    // Each edge with the corners opposite to it, one a face; an ordered map keeps the springs in a fixed order.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
            opposite[{low, high}].push_back(face[(k + 2) % 3]);
        }
    for (const auto& [edge, corners] : opposite)
        springs.push_back({edge.first, edge.second, glm::distance(positions[edge.first], positions[edge.second]),
                           SpringKind::structural});
    for (const auto& [edge, corners] : opposite)
        if (corners.size() == 2 && corners[0] != corners[1])
            springs.push_back({corners[0], corners[1], glm::distance(positions[corners[0]], positions[corners[1]]),
                               SpringKind::bend});
}

}  // namespace nuno
