// Puts every shape into the coordinates of its formulas.
#include "model/body.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// A rotation that takes the y axis to a unit vector.
glm::dmat3 rotation_from_y(const glm::dvec3& y)
{
    const glm::dvec3 other = std::abs(y.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 z = glm::normalize(glm::cross(other, y));
    return {glm::cross(y, z), y, z};
}

PlacedBody placed(const Plane& plane)
{
    const glm::dvec3 normal = glm::normalize(glm::dvec3(plane.normal));
    return {{normal * double(plane.offset), rotation_from_y(normal)}, {}, 0, &plane.motion, nullptr};
}

PlacedBody placed(const Sphere& sphere)
{
    return {{glm::dvec3(sphere.centre), glm::dmat3(1)}, {}, sphere.radius, &sphere.motion, nullptr};
}

PlacedBody placed(const Capsule& capsule)
{
    const glm::dvec3 from(capsule.from), to(capsule.to);
    const double length = glm::length(to - from);
    const glm::dvec3 y = length > 0 ? (to - from) / length : glm::dvec3(0, 1, 0);
    return {{0.5 * (from + to), rotation_from_y(y)},
            {0, static_cast<float>(length / 2), 0},
            capsule.radius,
            &capsule.motion,
            nullptr};
}

PlacedBody placed(const Box& box)
{
    return {{glm::dvec3(box.centre), glm::mat3_cast(glm::normalize(glm::dquat(box.rotation)))},
            0.5f * box.size,
            0,
            &box.motion,
            nullptr};
}

PlacedBody placed(const MeshBody& body)
{
    return {{glm::dvec3(body.position), glm::mat3_cast(glm::normalize(glm::dquat(body.rotation)))},
            {},
            0,
            &body.motion,
            body.grid.get()};
}

}  // namespace

std::vector<PlacedBody> placed_bodies(const Bodies& bodies)
{
    std::vector<PlacedBody> all;
    for (const Plane& plane : bodies.planes) all.push_back(placed(plane));
    for (const Sphere& sphere : bodies.spheres) all.push_back(placed(sphere));
    for (const Capsule& capsule : bodies.capsules) all.push_back(placed(capsule));
    for (const Box& box : bodies.boxes) all.push_back(placed(box));
    for (const MeshBody& body : bodies.meshes) all.push_back(placed(body));
    return all;
}

}  // namespace nuno
