// Bodies as the triangles that are drawn.
#include "app/body_picker.h"

#include "render/body_mesh.h"

namespace nuno {
namespace {

std::vector<glm::uvec3> faces_of(const BodyGeometry& geometry)
{
    std::vector<glm::uvec3> faces;
    for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3)
        faces.emplace_back(geometry.indices[i], geometry.indices[i + 1], geometry.indices[i + 2]);
    return faces;
}

// Frontmost body of one shape, compared with those before it.
class Frontmost
{
  public:
    Frontmost(const PickView& view, glm::vec2 place) : view_(view), place_(place) {}

    void look(std::size_t body, const Pose& pose, std::span<const glm::vec3> points, std::span<const glm::uvec3> faces)
    {
        std::vector<glm::vec3> seen;
        seen.reserve(points.size());
        for (const glm::vec3& point : points)
            seen.push_back(project_or_behind(view_, glm::vec3(pose.rotation * glm::dvec3(point) + pose.position)));
        const std::optional<FaceHit> hit = frontmost_face(seen, faces, place_);
        if (hit && (!hit_ || hit->depth < hit_->depth)) hit_ = BodyHit{body, hit->depth};
    }
    const std::optional<BodyHit>& hit() const { return hit_; }

  private:
    const PickView& view_;
    glm::vec2 place_;
    std::optional<BodyHit> hit_;
};

}  // namespace

std::optional<BodyHit> pick_body(const Bodies& bodies, double time_s, const PickView& view, glm::vec2 place)
{
    BodyGeometry round;
    append_rounded_box(round);
    const std::vector<glm::uvec3> round_faces = faces_of(round);
    const std::vector<PlacedBody> placed = placed_bodies(bodies);
    const std::size_t first_mesh = placed.size() - bodies.meshes.size();
    Frontmost frontmost(view, place);
    std::vector<glm::vec3> points;
    for (std::size_t i = bodies.planes.size(); i < placed.size(); ++i) {
        const Pose pose = pose_at(*placed[i].motion, placed[i].rest, time_s);
        if (i >= first_mesh) {
            const TriangleMesh& mesh = bodies.meshes[i - first_mesh].mesh;
            frontmost.look(i, pose, mesh.positions, mesh.faces);
            continue;
        }
        points.clear();
        for (const BodyVertex& vertex : round.vertices)
            points.push_back(placed[i].half_size * vertex.corner + placed[i].radius * vertex.normal);
        frontmost.look(i, pose, points, round_faces);
    }
    return frontmost.hit();
}

}  // namespace nuno
