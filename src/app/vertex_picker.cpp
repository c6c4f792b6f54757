// Picking in the picture: every vertex is projected once, then faces and vertices are compared in the plane.
#include "app/vertex_picker.h"

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kBehind = std::numeric_limits<float>::infinity();  // depth of a vertex that is behind the camera
constexpr float kAboutAsClose = 4.0f;

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

// Depth at `place` of the projected triangle, none where it does not cover the place. Depth after the division by w is
// linear over the picture, so the weights in the picture are those of the depth.
std::optional<float> depth_at(glm::vec2 place, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    if (a.z == kBehind || b.z == kBehind || c.z == kBehind) return std::nullopt;
    const glm::vec2 to_a = glm::vec2(a) - place, to_b = glm::vec2(b) - place, to_c = glm::vec2(c) - place;
    const float wa = cross(to_b, to_c), wb = cross(to_c, to_a), wc = cross(to_a, to_b);
    const float area = wa + wb + wc;
    const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    if (!inside || area == 0) return std::nullopt;
    return (wa * a.z + wb * b.z + wc * c.z) / area;
}

std::optional<glm::uvec3> frontmost_face(std::span<const glm::vec3> seen, std::span<const glm::uvec3> faces,
                                         glm::vec2 place)
{
    std::optional<glm::uvec3> best;
    float best_depth = kBehind;
    for (const glm::uvec3& face : faces) {
        const std::optional<float> depth = depth_at(place, seen[face.x], seen[face.y], seen[face.z]);
        if (!depth || *depth >= best_depth) continue;
        best = face;
        best_depth = *depth;
    }
    return best;
}

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

std::optional<glm::vec3> project(const PickView& view, glm::vec3 point)
{
    const glm::vec4 clip = view.camera.view_projection * glm::vec4(point, 1);
    if (!(clip.w > 0)) return std::nullopt;
    const glm::vec3 ndc = glm::vec3(clip) / clip.w;
    return glm::vec3((ndc.x + 1) / 2 * view.size.x, (1 - ndc.y) / 2 * view.size.y, ndc.z);
}

std::optional<std::uint32_t> pick_vertex(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                         const PickView& view, glm::vec2 place, float reach)
{
    std::vector<glm::vec3> seen;
    seen.reserve(positions.size());
    for (const glm::vec4& position : positions)
        seen.push_back(project(view, glm::vec3(position)).value_or(glm::vec3(0, 0, kBehind)));
    if (const std::optional<glm::uvec3> face = frontmost_face(seen, faces, place))
        return nearest_corner(seen, *face, place);

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
