// Where a texture has seams: vertices that some faces wear with texture coordinates of their own. Files and pictures
// show a copy of such a vertex; the simulation knows nothing of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nuno {

struct TextureSeams
{
    std::vector<std::uint32_t> vertices;  // of each copy: whose it is
    std::vector<glm::vec2> uvs;           // and what it wears
    std::vector<glm::uvec3> faces;        // those of the mesh, with number vertex_count + c for copy c; none: no seam

    bool empty() const { return faces.empty(); }
};

// `uvs`: of each vertex; `corner_uvs`: of the three corners of each face. Copies are numbered as the faces need them.
TextureSeams find_seams(std::span<const glm::uvec3> faces, std::span<const glm::vec2> uvs,
                        std::span<const std::array<glm::vec2, 3>> corner_uvs);

// Values by vertex, then those of the copies.
template <class T>
std::vector<T> with_copies(std::span<const T> values, const TextureSeams& seams)
{
    std::vector<T> result(values.begin(), values.end());
    for (const std::uint32_t vertex : seams.vertices) result.push_back(values[vertex]);
    return result;
}

}  // namespace nuno
