// Dragging in a plane.
#include "app/point_drag.h"

#include <glm/geometric.hpp>

namespace nuno {

PointDrag::PointDrag(glm::vec3 point, glm::vec3 forward, const Ray& ray)
    : start_(point), normal_(glm::normalize(forward)), offset_(0), target_(point)
{
    offset_ = start_ - point_under(ray, start_);
}

// origin + t direction with (origin + t direction - start) . normal = 0
glm::vec3 PointDrag::point_under(const Ray& ray, glm::vec3 otherwise) const
{
    const float towards = glm::dot(ray.direction, normal_);
    const float t = glm::dot(start_ - ray.origin, normal_) / towards;
    return towards > 1e-3f && t > 0 ? ray.origin + t * ray.direction : otherwise;
}

void PointDrag::follow(const Ray& ray) { target_ = point_under(ray, target_ - offset_) + offset_; }

}  // namespace nuno
