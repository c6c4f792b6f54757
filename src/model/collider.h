// Rigid bodies that cloth rests on.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

// Half-space n . x >= offset, n of unit length, offset [m].
struct Plane
{
    glm::vec3 normal{0, 1, 0};
    float offset = 0;
};

struct Sphere
{
    glm::vec3 centre{0, 0, 0};  // [m]
    float radius = 1;           // [m]
};

struct Colliders
{
    std::vector<Plane> planes;
    std::vector<Sphere> spheres;
};

}  // namespace nuno
