// Who owns what, and the pairs of neighbouring faces.
#include "collision/face_elements.h"

#include <algorithm>

#include "collision/face_neighbours.h"

namespace nuno {

FaceElements::FaceElements(std::span<const glm::uvec3> faces, std::uint32_t vertex_count, ElementKinds kinds)
    : faces_(faces.begin(), faces.end()), owned_(faces.size())
{
    std::vector<std::uint8_t> taken(vertex_count);
    struct Side
    {
        glm::uvec2 edge;
        std::uint32_t face;
        int number;
    };
    std::vector<Side> sides;
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % 3];
            if (!taken[a]) owned_[f].vertices[i] = a;
            taken[a] = 1;
            sides.push_back({{std::min(a, b), std::max(a, b)}, f, i});
        }
    const auto ends = [](const Side& side) { return std::array{side.edge.x, side.edge.y, side.face}; };
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return ends(a) < ends(b); });
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (i == 0 || sides[i].edge != sides[i - 1].edge) {
            if (kinds == ElementKinds::all) owned_[sides[i].face].edges[sides[i].number] = sides[i].edge;
            edges_.push_back(sides[i].edge);
        }
}

NearPairs FaceElements::near_pairs() const
{
    std::uint32_t vertex_count = 0;
    for (const glm::uvec3& face : faces_) vertex_count = std::max({vertex_count, face.x + 1, face.y + 1, face.z + 1});
    const std::vector<FacePair> neighbours = neighbouring_faces(faces_, vertex_count);
    NearPairs near;
    auto next = neighbours.begin();
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        near.starts.push_back(static_cast<std::uint32_t>(near.pairs.size()));
        for (; next != neighbours.end() && next->a == f; ++next)
            for_pairs_of(f, next->b, [&](const ElementPair& pair) { near.pairs.push_back(pair); });
    }
    near.starts.push_back(static_cast<std::uint32_t>(near.pairs.size()));
    return near;
}

}  // namespace nuno
