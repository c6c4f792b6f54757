// Reads Wavefront OBJ files.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <glm/common.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "model/triangle_mesh.h"

namespace nuno {
namespace {

// The reader below takes what it cannot parse for 0 and forgives missing vertices, so numbers and indices are checked first.
void check_obj_text(const std::string& text, const std::string& path)
{
    std::istringstream lines(text);
    std::string line, word;
    long positions = 0;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        if (!(words >> word)) continue;
        if (word == "v") {
            ++positions;
            int count = 0;
            for (; count < 3 && words >> word; ++count)
                if (!std::isfinite(parse_number(word[0] == '+' ? word.substr(1) : word).value_or(NAN)))
                    throw Error(fmt::format("{}:{}: '{}' is no finite number; a vertex is `v x y z` in metres", path,
                                            number, word));
            if (count < 3) throw Error(fmt::format("{}:{}: a vertex needs three numbers, `v x y z`", path, number));
        } else if (word == "f") {
            int count = 0;
            for (; words >> word; ++count) {
                const auto index = parse_number(std::string_view(word).substr(0, word.find('/')));
                if (!index || *index == 0 || *index > double(positions) || -*index > double(positions))
                    throw Error(fmt::format("{}:{}: '{}' names no vertex; {} were given before this line (1 to {})",
                                            path, number, word, positions, positions));
            }
            if (count < 3) throw Error(fmt::format("{}:{}: a face needs at least three vertices", path, number));
        }
    }
}

// Places of vertices without texture coordinates: the two longest sides of the bounding box.
std::vector<glm::vec2> box_uvs(const std::vector<glm::vec3>& positions)
{
    glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
    for (const glm::vec3 p : positions) low = glm::min(low, p), high = glm::max(high, p);
    const glm::vec3 side = glm::max(high - low, glm::vec3(1e-12f));
    const int thinnest = side.x <= side.y && side.x <= side.z ? 0 : side.y <= side.z ? 1 : 2;
    const int u = thinnest == 0 ? 1 : 0, v = thinnest == 2 ? 1 : 2;
    std::vector<glm::vec2> uvs;
    for (const glm::vec3 p : positions) uvs.emplace_back((p[u] - low[u]) / side[u], (p[v] - low[v]) / side[v]);
    return uvs;
}

}  // namespace

TriangleMesh load_obj(const std::filesystem::path& path)
{
    const std::string text = read_text(path);
    check_obj_text(text, path.string());
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(text, "", config))
        throw Error(
            fmt::format("{}: is no OBJ file ({}); give `v x y z` and `f a b c` lines", path.string(), reader.Error()));

    const tinyobj::attrib_t& attributes = reader.GetAttrib();
    TriangleMesh mesh;
    for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3)
        mesh.positions.emplace_back(attributes.vertices[i], attributes.vertices[i + 1], attributes.vertices[i + 2]);
    if (!mesh.positions.empty()) mesh.uvs = box_uvs(mesh.positions);
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            for (std::size_t k = i; k < i + 3; ++k)
                if (corners[k].texcoord_index >= 0)
                    mesh.uvs[static_cast<std::size_t>(corners[k].vertex_index)] = {
                        attributes.texcoords[2 * static_cast<std::size_t>(corners[k].texcoord_index)],
                        attributes.texcoords[2 * static_cast<std::size_t>(corners[k].texcoord_index) + 1]};
            mesh.faces.emplace_back(corners[i].vertex_index, corners[i + 1].vertex_index, corners[i + 2].vertex_index);
        }
    }
    check_mesh(mesh, path.string());
    return mesh;
}

}  // namespace nuno
