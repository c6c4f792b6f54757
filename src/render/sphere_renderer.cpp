// One mesh of the unit sphere, drawn once an instance.
#include "render/sphere_renderer.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

constexpr int kMeridians = 48;
constexpr int kParallels = 24;

enum VertexSlot : GLuint
{
    slot_unit_sphere,
    slot_spheres
};

// Positions, which are the normals too; ring by ring from the top pole.
std::vector<glm::vec3> sphere_positions()
{
    std::vector<glm::vec3> positions;
    for (int ring = 0; ring <= kParallels; ++ring)
        for (int i = 0; i <= kMeridians; ++i) {
            const float polar = glm::pi<float>() * float(ring) / kParallels;
            const float azimuth = 2 * glm::pi<float>() * float(i) / kMeridians;
            positions.emplace_back(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                   std::sin(polar) * std::cos(azimuth));
        }
    return positions;
}

std::vector<std::uint32_t> sphere_indices()
{
    std::vector<std::uint32_t> indices;
    for (std::uint32_t ring = 0; ring < kParallels; ++ring)
        for (std::uint32_t i = 0; i < kMeridians; ++i) {
            const std::uint32_t a = ring * (kMeridians + 1) + i, b = a + kMeridians + 1;
            indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return indices;
}

}  // namespace

SphereRenderer::SphereRenderer()
    : program_(draw_program("render/sphere.vert", "render/sphere.frag")),
      unit_sphere_(make_buffer(sphere_positions(), GL_STATIC_DRAW)),
      indices_(make_buffer(sphere_indices(), GL_STATIC_DRAW)),
      index_count_(6 * kMeridians * kParallels)
{
    vertices_.attribute(ATTRIBUTE_POSITION, slot_unit_sphere, 3);
    vertices_.attribute(ATTRIBUTE_SPHERE, slot_spheres, 4);
    vertices_.per_instance(slot_spheres);
    vertices_.vertices(slot_unit_sphere, unit_sphere_.id(), sizeof(glm::vec3));
    vertices_.indices(indices_.id());
}

void SphereRenderer::set_spheres(std::span<const Sphere> spheres)
{
    std::vector<glm::vec4> placed;
    for (const Sphere& sphere : spheres) placed.emplace_back(sphere.centre, sphere.radius);
    sphere_count_ = static_cast<GLsizei>(placed.size());
    const std::size_t bytes = placed.size() * sizeof(glm::vec4);
    if (spheres_.size_bytes() < bytes) spheres_ = Buffer(bytes, nullptr, GL_DYNAMIC_DRAW);
    if (bytes > 0) spheres_.update(0, placed);
    vertices_.vertices(slot_spheres, spheres_.id(), sizeof(glm::vec4));
}

void SphereRenderer::draw() const
{
    program_.use();
    draw_faces();
}

void SphereRenderer::draw_faces() const
{
    if (sphere_count_ == 0) return;
    vertices_.bind();
    glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, sphere_count_);
}

}  // namespace nuno
