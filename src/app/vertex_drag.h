// A vertex that follows the pointer in the plane parallel to the screen in which it was taken.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "render/camera.h"

namespace nuno {

class VertexDrag
{
  public:
    // `position`: where the vertex is [m]; `forward`: the direction in which the camera looks; `ray`: through the
    // pointer.
    VertexDrag(std::uint32_t vertex, glm::vec3 position, glm::vec3 forward, const Ray& ray);

    std::uint32_t vertex() const { return vertex_; }
    // Where the vertex is to be [m]: it keeps the offset from the pointer that it had when it was taken.
    glm::vec3 target() const { return target_; }
    // Moves the target under the pointer; it stays where the plane is not in front of the pointer.
    void follow(const Ray& ray);

  private:
    glm::vec3 point_under(const Ray& ray, glm::vec3 otherwise) const;

    std::uint32_t vertex_;
    glm::vec3 position_, normal_, offset_, target_;
};

}  // namespace nuno
