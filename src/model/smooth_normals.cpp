// Adds the normals of faces to their vertices, face by face.
#include "model/smooth_normals.h"

#include <glm/geometric.hpp>

namespace nuno {

std::vector<glm::vec3> smooth_normals(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces)
{
    std::vector<glm::vec3> normals(positions.size(), glm::vec3(0));
    for (const glm::uvec3& face : faces) {
        const glm::vec3 a(positions[face.x]), b(positions[face.y]), c(positions[face.z]);
        const glm::vec3 normal = glm::cross(b - a, c - a);
        for (int k = 0; k < 3; ++k) normals[face[k]] += normal;
    }
    for (glm::vec3& normal : normals) {
        const float size = glm::length(normal);
        normal = size > 0 ? normal / size : glm::vec3(0, 0, 1);
    }
    return normals;
}

}  // namespace nuno
