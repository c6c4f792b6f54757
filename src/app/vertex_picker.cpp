// Picking in the picture: every vertex is projected once, then faces and vertices are compared in the plane.
#include "app/vertex_picker.h"

#include <cmath>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kAboutAsClose = 4.0f;

float distance_to(glm::vec2 place, const glm::vec3& seen)
{
    return seen.z == kBehind ? kBehind : glm::distance(place, glm::vec2(seen));
}

std::uint32_t nearest_corner(std::span<const glm::vec3> seen, const glm::uvec3& face, glm::vec2 place)
{
    std::uint32_t best = face.x;
    for (const std::uint32_t corner : {face.y, face.z})
        if (distance_to(place, seen[corner]) < distance_to(place, seen[best])) best = corner;
    return best;
}

}  // namespace

std::optional<std::uint32_t> pick_vertex(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                         const PickView& view, glm::vec2 place, float reach, float hidden_from)
{
    std::vector<glm::vec3> seen;
    seen.reserve(positions.size());
    for (const glm::vec4& position : positions) seen.push_back(project_or_behind(view, glm::vec3(position)));
    if (const std::optional<FaceHit> hit = frontmost_face(seen, faces, place); hit && hit->depth < hidden_from)
        return nearest_corner(seen, hit->face, place);
    if (hidden_from != kBehind) return std::nullopt;

    std::optional<std::uint32_t> best;
    std::tuple<float, float> best_rank{kBehind, kBehind};
    for (std::uint32_t v = 0; v < seen.size(); ++v) {
        const float distance = distance_to(place, seen[v]);
        if (!(distance <= reach)) continue;
        const std::tuple rank(std::floor(distance / kAboutAsClose), seen[v].z);
        if (rank < best_rank) best = v, best_rank = rank;
    }
    return best;
}

}  // namespace nuno
