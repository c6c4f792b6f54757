// A copy for each pair of a vertex and texture coordinates that are not its own.
#include "model/texture_seams.h"

#include <cassert>
#include <map>
#include <tuple>

namespace nuno {

TextureSeams find_seams(std::span<const glm::uvec3> faces, std::span<const glm::vec2> uvs,
                        std::span<const std::array<glm::vec2, 3>> corner_uvs)
{
    assert(corner_uvs.size() == faces.size());
    TextureSeams seams;
    seams.faces.assign(faces.begin(), faces.end());
    std::map<std::tuple<std::uint32_t, float, float>, std::size_t> copies;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = faces[f][k];
            const glm::vec2 uv = corner_uvs[f][static_cast<std::size_t>(k)];
            if (uv == uvs[vertex]) continue;
            const auto [copy, is_new] = copies.try_emplace({vertex, uv.x, uv.y}, seams.vertices.size());
            if (is_new) {
                seams.vertices.push_back(vertex);
                seams.uvs.push_back(uv);
            }
            seams.faces[f][k] = static_cast<std::uint32_t>(uvs.size() + copy->second);
        }
    if (seams.vertices.empty()) seams.faces.clear();
    return seams;
}

}  // namespace nuno
