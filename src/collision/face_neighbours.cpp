// Rings of faces around vertices.
#include "collision/face_neighbours.h"

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

std::vector<FacePair> neighbouring_faces(std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
{
    const FacesAround around = faces_around(faces, vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        if (const std::uint32_t count = around.starts[v + 1] - around.starts[v]; count > kMostFacesAround)
            throw Error(fmt::format("vertex {} is a corner of {} faces; where layers collide it may be one of {}", v,
                                    count, kMostFacesAround));
    std::vector<FacePair> pairs;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const auto first = static_cast<std::ptrdiff_t>(pairs.size());
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = faces[f][corner];
            for (std::uint32_t i = around.starts[v]; i < around.starts[v + 1]; ++i)
                if (around.faces[i] > f) pairs.push_back({f, around.faces[i]});
        }
        std::sort(pairs.begin() + first, pairs.end());
        pairs.erase(std::unique(pairs.begin() + first, pairs.end()), pairs.end());
    }
    return pairs;
}

}  // namespace nuno
