// Points and faces in the plane of the picture.
#include "app/pick_view.h"

#include <glm/matrix.hpp>

namespace nuno {
namespace {

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

}  // namespace

std::optional<glm::vec3> project(const PickView& view, glm::vec3 point)
{
    const glm::vec4 clip = view.camera.view_projection * glm::vec4(point, 1);
    if (!(clip.w > 0)) return std::nullopt;
    const glm::vec3 ndc = glm::vec3(clip) / clip.w;
    return glm::vec3((ndc.x + 1) / 2 * view.size.x, (1 - ndc.y) / 2 * view.size.y, ndc.z);
}

glm::vec3 project_or_behind(const PickView& view, glm::vec3 point)
{
    return project(view, point).value_or(glm::vec3(0, 0, kBehind));
}

glm::vec3 unproject(const PickView& view, const glm::vec3& place_and_depth)
{
    const glm::vec2 share = glm::vec2(place_and_depth) / view.size;
    const glm::dvec4 ndc(2 * share.x - 1, 1 - 2 * share.y, place_and_depth.z, 1);
    const glm::dvec4 point = glm::inverse(glm::dmat4(view.camera.view_projection)) * ndc;
    return glm::vec3(glm::dvec3(point) / point.w);
}

std::optional<FaceHit> frontmost_face(std::span<const glm::vec3> seen, std::span<const glm::uvec3> faces,
                                      glm::vec2 place)
{
    std::optional<FaceHit> best;
    for (const glm::uvec3& face : faces) {
        const std::optional<float> depth = depth_at(place, seen[face.x], seen[face.y], seen[face.z]);
        if (depth && (!best || *depth < best->depth)) best = FaceHit{face, *depth};
    }
    return best;
}

}  // namespace nuno
