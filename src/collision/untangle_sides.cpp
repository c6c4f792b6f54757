// The edges that go through a face an odd number of times cut the mesh; what they cut off, a bulge or a corner that
// went through a layer, goes back along the normals of the faces that it went through.
#include <algorithm>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "collision/untangle_moves.h"
#include "collision/vertex_sets.h"

namespace nuno {
namespace {

struct EdgeCrossing
{
    std::uint32_t a, b;  // a < b
    glm::dvec3 to_a;     // unit normal of the face, towards the side of a
    auto ends() const { return std::pair(a, b); }
};

glm::dvec3 place_of(std::uint32_t vertex, std::span<const glm::vec4> positions)
{
    return glm::dvec3(positions[vertex]);
}

// In order of edges; each edge and face once, though each face beside the edge comes with it.
std::vector<EdgeCrossing> edge_crossings(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces,
                                         std::span<const glm::vec4> positions)
{
    struct Key
    {
        std::uint32_t a, b, face;
        auto parts() const { return std::tuple(a, b, face); }
    };
    std::vector<Key> keys;
    for (const Tangle& tangle : tangles)
        for (int i = 0; i < tangle.meeting.crossing_count; ++i) {
            const Crossing& crossing = tangle.meeting.crossings[std::size_t(i)];
            const auto [a, b] =
                std::minmax({edge_vertex(tangle, crossing, 0, faces), edge_vertex(tangle, crossing, 1, faces)});
            keys.push_back({a, b, crossing.edge_of_first ? tangle.faces.b : tangle.faces.a});
        }
    std::sort(keys.begin(), keys.end(), [](const Key& p, const Key& q) { return p.parts() < q.parts(); });
    keys.erase(std::unique(keys.begin(), keys.end(), [](const Key& p, const Key& q) { return p.parts() == q.parts(); }),
               keys.end());

    std::vector<EdgeCrossing> crossings;
    for (const Key& key : keys) {
        const glm::uvec3& face = faces[key.face];
        const glm::dvec3 corner = place_of(face.x, positions);
        const glm::dvec3 normal =
            unit_or_zero(glm::cross(place_of(face.y, positions) - corner, place_of(face.z, positions) - corner));
        const double side = glm::dot(normal, place_of(key.a, positions) - place_of(key.b, positions));
        crossings.push_back({key.a, key.b, side < 0 ? -normal : normal});
    }
    return crossings;
}

}  // namespace

void add_side_moves(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces, std::span<const MeshEdge> edges,
                    std::span<const glm::vec4> positions, Directions& ways)
{
    const std::vector<EdgeCrossing> crossings = edge_crossings(tangles, faces, positions);
    VertexSets parts(positions.size());  // of the mesh, joined by its edges
    auto next = crossings.begin();
    for (const MeshEdge& edge : edges) {  // both in the same order
        const auto first = next;
        while (next != crossings.end() && next->ends() == std::pair(edge.a, edge.b)) ++next;
        if ((next - first) % 2 == 0) parts.join(edge.a, edge.b);
    }
    Directions way_of_part(positions.size(), glm::dvec3(0));
    for (const EdgeCrossing& crossing : crossings) {
        const std::uint32_t a = parts.find(crossing.a), b = parts.find(crossing.b);
        if (a == b) continue;
        if (parts.size(a) <= parts.size(b)) way_of_part[a] -= crossing.to_a;
        if (parts.size(b) < parts.size(a)) way_of_part[b] += crossing.to_a;
    }
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const glm::dvec3& way = way_of_part[parts.find(v)];
        const double length = glm::length(way);
        if (length > 0) ways[v] += way / length;
    }
}

}  // namespace nuno
