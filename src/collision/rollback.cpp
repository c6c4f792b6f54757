// Clusters by union-find over the vertices of impacts.
#include "collision/rollback.h"

#include <algorithm>

#include "collision/vertex_sets.h"

namespace nuno {

Clusters roll_back(std::span<const Impact> impacts, double kept, std::span<const glm::vec4> start,
                   std::span<glm::vec4> end, std::span<std::uint8_t> moved)
{
    std::vector<std::uint32_t> vertices;
    for (const Impact& impact : impacts)
        for (int i = 0; i < 4; ++i) vertices.push_back(impact.pair.vertices[i]);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto number = [&](std::uint32_t vertex) {
        return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), vertex) -
                                          vertices.begin());
    };

    VertexSets sets(vertices.size());
    for (const Impact& impact : impacts)
        for (int i = 1; i < 4; ++i) sets.join(number(impact.pair.vertices[0]), number(impact.pair.vertices[i]));
    std::vector<double> times(vertices.size(), 1.0);
    for (const Impact& impact : impacts) {
        double& time = times[sets.find(number(impact.pair.vertices[0]))];
        time = std::min(time, impact.time);
    }

    Clusters clusters;
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        const std::uint32_t leader = sets.find(i), v = vertices[i];
        clusters.count += leader == i;
        clusters.largest = std::max(clusters.largest, sets.size(leader));
        clusters.held_back += end[v].w == 0 && start[v] != end[v];
        const glm::dvec3 from(start[v]), to(end[v]);
        end[v] = glm::vec4(glm::vec3(from + kept * times[leader] * (to - from)), end[v].w);
        moved[v] = 1;
    }
    return clusters;
}

}  // namespace nuno
