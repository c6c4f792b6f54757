// A point that follows the pointer in the plane parallel to the screen in which it was taken.
#pragma once

#include <glm/vec3.hpp>

#include "render/camera.h"

namespace nuno {

class PointDrag
{
  public:
    // `point`: where it is [m]; `forward`: the direction in which the camera looks; `ray`: through the pointer.
    PointDrag(glm::vec3 point, glm::vec3 forward, const Ray& ray);

    // Where the point was taken [m].
    glm::vec3 start() const { return start_; }
    // Where the point is to be [m]: it keeps the offset from the pointer that it had when it was taken.
    glm::vec3 target() const { return target_; }
    // Moves the target under the pointer; it stays where the plane is not in front of the pointer.
    void follow(const Ray& ray);

  private:
    glm::vec3 point_under(const Ray& ray, glm::vec3 otherwise) const;

    glm::vec3 start_, normal_, offset_, target_;
};

}  // namespace nuno
