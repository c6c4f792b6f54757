// Who owns what, and the pairs of neighbouring faces.
#include "collision/face_elements.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace nuno {
namespace {

// All pairs of faces around a vertex are kept, so their number has a bound.
constexpr std::uint32_t kMostFacesAround = 1000;

// Faces around every vertex, in order of their numbers: those of vertex v are [starts[v], starts[v + 1]) of `faces`.
struct FacesAround
{
    std::vector<std::uint32_t> starts, faces;
};

FacesAround faces_around(std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
{
    FacesAround around{std::vector<std::uint32_t>(vertex_count + 1), {}};
    for (const glm::uvec3& face : faces)
        for (int corner = 0; corner < 3; ++corner) ++around.starts[face[corner] + 1];
    for (std::uint32_t v = 0; v < vertex_count; ++v) around.starts[v + 1] += around.starts[v];
    std::vector<std::uint32_t> next(around.starts.begin(), around.starts.end() - 1);
    around.faces.resize(3 * faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (int corner = 0; corner < 3; ++corner) around.faces[next[faces[f][corner]]++] = f;
    return around;
}

}  // namespace

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
    const FacesAround around = faces_around(faces_, vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        if (const std::uint32_t count = around.starts[v + 1] - around.starts[v]; count > kMostFacesAround)
            throw Error(fmt::format("vertex {} is a corner of {} faces; where layers collide it may be one of {}", v,
                                    count, kMostFacesAround));
    NearPairs near;
    near.starts.push_back(0);
    std::vector<std::uint32_t> others;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        others.clear();
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = faces_[f][corner];
            for (std::uint32_t i = around.starts[v]; i < around.starts[v + 1]; ++i)
                if (around.faces[i] > f) others.push_back(around.faces[i]);
        }
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        for (const std::uint32_t g : others)
            for_pairs_of(f, g, [&](const ElementPair& pair) { near.pairs.push_back(pair); });
        near.starts.push_back(static_cast<std::uint32_t>(near.pairs.size()));
    }
    return near;
}

}  // namespace nuno
