// Dragging in a plane.
#include "app/vertex_drag.h"

#include <glm/geometric.hpp>

namespace nuno {

VertexDrag::VertexDrag(std::uint32_t vertex, glm::vec3 position, glm::vec3 forward, const Ray& ray)
    : vertex_(vertex), position_(position), normal_(glm::normalize(forward)), offset_(0), target_(position)
{
    offset_ = position_ - point_under(ray, position_);
}

// origin + t direction with (origin + t direction - position) . normal = 0
glm::vec3 VertexDrag::point_under(const Ray& ray, glm::vec3 otherwise) const
{
    const float towards = glm::dot(ray.direction, normal_);
    const float t = glm::dot(position_ - ray.origin, normal_) / towards;
    return towards > 1e-3f && t > 0 ? ray.origin + t * ray.direction : otherwise;
}

void VertexDrag::follow(const Ray& ray) { target_ = point_under(ray, target_ - offset_) + offset_; }

}  // namespace nuno
