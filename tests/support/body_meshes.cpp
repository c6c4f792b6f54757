// Closed meshes that several tests start from.
#include "support/body_meshes.h"

namespace nuno {

TriangleMesh box_mesh(glm::vec3 size)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.push_back(0.5f * size *
                                 glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    mesh.uvs.resize(8);
    mesh.faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

TriangleMesh dented_box_mesh(glm::vec3 size, float depth)
{
    TriangleMesh mesh = box_mesh(size);
    const auto tip = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0, size.y / 2 - depth, 0);
    mesh.uvs.emplace_back(0, 0);
    std::erase_if(mesh.faces, [](const glm::uvec3& f) { return f == glm::uvec3(2, 6, 7) || f == glm::uvec3(2, 7, 3); });
    for (const glm::uvec2 side : {glm::uvec2(2, 6), {6, 7}, {7, 3}, {3, 2}}) mesh.faces.emplace_back(side, tip);
    return mesh;
}

}  // namespace nuno
