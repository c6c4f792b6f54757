// Bodies as instances of a rounded box, and meshes.
#include "render/body_renderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "render/body_mesh.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

enum VertexSlot : GLuint
{
    slot_geometry,
    slot_instances
};

// As render/placed_body.glsl reads it.
struct Instance
{
    glm::vec4 position;  // [m]; w: radius
    glm::vec4 axis[3];   // w: half size along it [m]
};

Instance instance_of(const PlacedBody& body, double time_s)
{
    const Pose pose = pose_at(*body.motion, body.rest, time_s);
    const glm::vec3 half_size = body.grid ? glm::vec3(1) : body.half_size;
    Instance instance;
    instance.position = glm::vec4(glm::vec3(pose.position), body.radius);
    for (int k = 0; k < 3; ++k) instance.axis[k] = glm::vec4(glm::vec3(pose.rotation[k]), half_size[k]);
    return instance;
}

Bounds corners_of(const TriangleMesh& mesh)
{
    Bounds bounds{glm::vec3(0), glm::vec3(0)};
    for (const glm::vec3& position : mesh.positions) {
        bounds.low = glm::min(bounds.low, position);
        bounds.high = glm::max(bounds.high, position);
    }
    return bounds;
}

// Of a mesh between `corners`, placed.
Bounds placed_bounds(const Bounds& corners, const Instance& instance)
{
    const glm::vec3 position(instance.position);
    Bounds bounds{position, position};
    for (const glm::vec4& axis : instance.axis) {
        const int k = static_cast<int>(&axis - instance.axis);
        const glm::vec3 direction(axis), low = (axis.w * corners.low[k] - instance.position.w) * direction;
        const glm::vec3 high = (axis.w * corners.high[k] + instance.position.w) * direction;
        bounds.low += glm::min(low, high);
        bounds.high += glm::max(low, high);
    }
    return bounds;
}

}  // namespace

BodyRenderer::BodyRenderer()
{
    vertices_.attribute(ATTRIBUTE_POSITION, slot_geometry, 3, offsetof(BodyVertex, corner));
    vertices_.attribute(ATTRIBUTE_NORMAL, slot_geometry, 3, offsetof(BodyVertex, normal));
    constexpr GLuint attributes[] = {ATTRIBUTE_BODY, ATTRIBUTE_BODY_X, ATTRIBUTE_BODY_Y, ATTRIBUTE_BODY_Z};
    for (GLuint k = 0; k < 4; ++k) vertices_.attribute(attributes[k], slot_instances, 4, k * sizeof(glm::vec4));
    vertices_.per_instance(slot_instances);
    build_geometry({});
}

void BodyRenderer::build_geometry(const Bodies& bodies)
{
    BodyGeometry geometry;
    append_rounded_box(geometry);
    parts_ = {{0, static_cast<GLsizei>(geometry.indices.size()), 0, 0, {glm::vec3(-1), glm::vec3(1)}}};
    built_.clear();
    for (const MeshBody& body : bodies.meshes) {
        const std::size_t first = geometry.indices.size();
        append_mesh(geometry, body.mesh);
        parts_.push_back({first, static_cast<GLsizei>(geometry.indices.size() - first), 1, 0, corners_of(body.mesh)});
        built_.push_back(body.grid);
    }
    geometry_ = make_buffer(geometry.vertices, GL_STATIC_DRAW);
    indices_ = make_buffer(geometry.indices, GL_STATIC_DRAW);
    vertices_.vertices(slot_geometry, geometry_.id(), sizeof(BodyVertex));
    vertices_.indices(indices_.id());
}

void BodyRenderer::set_bodies(const Bodies& bodies, double time_s)
{
    const auto same = [](const MeshBody& body, const std::shared_ptr<const DistanceGrid>& grid) {
        return body.grid == grid;
    };
    if (!std::equal(bodies.meshes.begin(), bodies.meshes.end(), built_.begin(), built_.end(), same))
        build_geometry(bodies);
    const std::vector<PlacedBody> placed = placed_bodies(bodies);
    std::vector<Instance> instances;
    for (std::size_t i = bodies.planes.size(); i < placed.size(); ++i)
        instances.push_back(instance_of(placed[i], time_s));
    const std::size_t round = instances.size() - bodies.meshes.size();
    parts_[0].instance_count = static_cast<GLsizei>(round);
    for (std::size_t k = 1; k < parts_.size(); ++k) parts_[k].first_instance = static_cast<GLuint>(round + k - 1);
    bounds_.clear();
    for (std::size_t i = 0; i < instances.size(); ++i)
        bounds_.push_back(placed_bounds(parts_[i < round ? 0 : i - round + 1].corners, instances[i]));
    const std::size_t bytes = instances.size() * sizeof(Instance);
    if (instances_.size_bytes() < bytes) instances_ = Buffer(bytes, nullptr, GL_DYNAMIC_DRAW);
    if (bytes > 0) instances_.update(0, instances);
    vertices_.vertices(slot_instances, instances_.id(), sizeof(Instance));
}

void BodyRenderer::draw_faces() const
{
    vertices_.bind();
    for (const Part& part : parts_) {
        if (part.instance_count == 0) continue;
        const std::size_t offset = part.first_index * sizeof(std::uint32_t);
        const void* first = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, first, part.instance_count,
                                            part.first_instance);
    }
}

}  // namespace nuno
