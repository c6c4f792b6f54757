// Reads Wavefront OBJ files.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
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

// The reader below takes what it cannot parse for 0 and forgives missing vertices, so numbers and indices are checked
// first.
class ObjCheck
{
  public:
    ObjCheck(const std::string& text, std::string path) : path_(std::move(path))
    {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            line.resize(std::min(line.size(), line.find('#')));
            text_ += line + '\n';
            std::istringstream words(line);
            std::string word;
            if (!(words >> word)) continue;
            if (word == "v") check_numbers(words, 3, "a vertex is `v x y z` in metres"), ++positions_;
            if (word == "vt") check_numbers(words, 1, "a texture coordinate is `vt u v`"), ++texcoords_;
            if (word == "f") check_face(words);
        }
    }

    // The file without its comments, which the reader takes for numbers after a face.
    const std::string& text() const { return text_; }

  private:
    [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", path_, line_, what)); }

    void check_numbers(std::istringstream& words, int least, const char* form) const
    {
        int count = 0;
        for (std::string word; words >> word; ++count)
            if (!std::isfinite(parse_number(word[0] == '+' ? word.substr(1) : word).value_or(NAN)))
                fail(fmt::format("'{}' is no finite number; {}", word, form));
        if (count < least) fail(fmt::format("{} numbers are too few; {}", count, form));
    }

    void check_face(std::istringstream& words) const
    {
        int corners = 0;
        for (std::string word; words >> word; ++corners) {
            const std::size_t slash = word.find('/');
            check_index(word, word.substr(0, slash), positions_, "vertex");
            if (slash == word.npos) continue;
            const std::string texcoord = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
            if (!texcoord.empty()) check_index(word, texcoord, texcoords_, "texture coordinate");
        }
        if (corners < 3) fail("a face needs at least three vertices");
    }

    // Indices count from 1, or backwards from -1.
    void check_index(const std::string& word, const std::string& index, long count, const char* what) const
    {
        const double i = parse_number(index).value_or(0);
        if (i == 0 || i != std::floor(i) || std::abs(i) > double(count))
            fail(fmt::format("'{}' names no {}; {} were given before this line (1 to {})", word, what, count, count));
    }

    std::string path_, text_;
    int line_ = 0;
    long positions_ = 0, texcoords_ = 0;
};

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
    const ObjCheck checked(read_text(path), path.string());
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(checked.text(), "", config))
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
