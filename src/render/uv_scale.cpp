// Sums over the faces of a sheet.
#include "render/uv_scale.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {

glm::vec2 metres_of_uv(std::span<const glm::uvec3> faces, std::span<const glm::vec3> rest,
                       std::span<const glm::vec2> uvs)
{
    glm::vec2 sum(0);
    float total = 0;
    for (const glm::uvec3& face : faces) {
        const glm::vec3 e1 = rest[face.y] - rest[face.x], e2 = rest[face.z] - rest[face.x];
        const glm::vec2 t1 = uvs[face.y] - uvs[face.x], t2 = uvs[face.z] - uvs[face.x];
        const float uv_area = t1.x * t2.y - t1.y * t2.x, area = glm::length(glm::cross(e1, e2));
        if (uv_area == 0 || area == 0) continue;
        const glm::vec3 along_u = (t2.y * e1 - t1.y * e2) / uv_area, along_v = (t1.x * e2 - t2.x * e1) / uv_area;
        sum += area * glm::vec2(glm::length(along_u), glm::length(along_v));
        total += area;
    }
    return total > 0 ? sum / total : glm::vec2(1);
}

}  // namespace nuno
