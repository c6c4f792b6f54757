// Reads Wavefront OBJ files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <sstream>

#include <glm/common.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "model/polygon.h"
#include "model/triangle_mesh.h"

namespace nuno {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();  // no texture coordinate
constexpr std::size_t kMostCorners = 256;  // of a face: cutting it up takes the cube of them

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

class ObjReader
{
  public:
    ObjReader(const std::string& text, std::string path) : path_(std::move(path))
    {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            line.resize(std::min(line.size(), line.find('#')));
            read_line(line);
        }
    }

    TriangleMesh mesh()
    {
        if (!mesh_.positions.empty()) mesh_.uvs = box_uvs(mesh_.positions);
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
            for (int k = 0; k < 3; ++k)
                if (texcoords_of_[f][k] != kNone) mesh_.uvs[mesh_.faces[f][k]] = texcoords_[texcoords_of_[f][k]];
        find_texture_seams();
        for (auto& [name, vertices] : mesh_.groups) {
            std::sort(vertices.begin(), vertices.end());
            vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        }
        return std::move(mesh_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", path_, line_, what)); }

    void read_line(const std::string& line)
    {
        std::istringstream words(line);
        std::string word;
        if (!(words >> word)) return;
        if (word == "v") {
            const auto n = numbers(words, 3, "a vertex is `v x y z` in metres");
            mesh_.positions.emplace_back(n[0], n[1], n[2]);
        }
        if (word == "vt") {
            const auto n = numbers(words, 1, "a texture coordinate is `vt u v`");
            texcoords_.emplace_back(n[0], n.size() > 1 ? n[1] : 0);
        }
        if (word == "f") read_face(words);
        if (word == "o" || word == "g") groups_.clear();
        if (word == "o" && !(words >> object_)) object_.clear();
        if (word == "g") groups_.assign(std::istream_iterator<std::string>(words), {});
    }

    std::vector<float> numbers(std::istringstream& words, std::size_t least, const char* form) const
    {
        std::vector<float> numbers;
        for (std::string word; words >> word;) {
            const double number = parse_number(word[0] == '+' ? word.substr(1) : word).value_or(NAN);
            if (!std::isfinite(static_cast<float>(number)))
                fail(fmt::format("'{}' is no finite number; {}", word, form));
            numbers.push_back(static_cast<float>(number));
        }
        if (numbers.size() < least) fail(fmt::format("{} numbers are too few; {}", numbers.size(), form));
        return numbers;
    }

    // A corner without a texture coordinate has its vertex's.
    void find_texture_seams()
    {
        std::vector<std::array<glm::vec2, 3>> corner_uvs;
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            const auto uv_of = [&](int k) {
                const std::uint32_t texcoord = texcoords_of_[f][k];
                return texcoord == kNone ? mesh_.uvs[mesh_.faces[f][k]] : texcoords_[texcoord];
            };
            corner_uvs.push_back({uv_of(0), uv_of(1), uv_of(2)});
        }
        mesh_.seams = find_seams(mesh_.faces, mesh_.uvs, corner_uvs);
    }

    void read_face(std::istringstream& words)
    {
        std::vector<std::uint32_t> corners, texcoords;
        for (std::string word; words >> word;) {
            const std::size_t slash = word.find('/');
            corners.push_back(number_of(word, word.substr(0, slash), mesh_.positions.size(), "vertex"));
            texcoords.push_back(kNone);
            if (slash == word.npos) continue;
            const std::string texcoord = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
            if (!texcoord.empty())
                texcoords.back() = number_of(word, texcoord, texcoords_.size(), "texture coordinate");
        }
        if (corners.size() < 3) fail("a face needs at least three vertices");
        if (corners.size() > kMostCorners)
            fail(fmt::format("a face of {} vertices is too much; cut it into ones of at most {}", corners.size(),
                             kMostCorners));
        const std::vector<glm::uvec3> faces = cut_polygon(mesh_.positions, corners);
        if (faces.empty())
            fail("this polygon crosses or touches itself, or has no area; cut it into triangles where it was made");
        mesh_.faces.insert(mesh_.faces.end(), faces.begin(), faces.end());
        const auto texcoord_of = [&](std::uint32_t vertex) {
            const auto corner = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
            return texcoords[static_cast<std::size_t>(corner)];
        };
        for (const glm::uvec3& face : faces)
            texcoords_of_.emplace_back(texcoord_of(face.x), texcoord_of(face.y), texcoord_of(face.z));
        for (const std::string& group : groups_) add_to(group, corners);
        if (!object_.empty()) add_to(object_, corners);
    }

    void add_to(const std::string& group, std::span<const std::uint32_t> corners)
    {
        std::vector<std::uint32_t>& vertices = mesh_.groups[group];
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }

    // Indices count from 1, or backwards from -1.
    std::uint32_t number_of(const std::string& word, const std::string& index, std::size_t count,
                            const char* what) const
    {
        const double i = parse_number(index).value_or(0);
        if (i == 0 || i != std::floor(i) || std::abs(i) > double(count))
            fail(fmt::format("'{}' names no {}; {} were given before this line (1 to {})", word, what, count, count));
        return static_cast<std::uint32_t>(i > 0 ? i - 1 : double(count) + i);
    }

    std::string path_;
    int line_ = 0;
    TriangleMesh mesh_;
    std::vector<glm::vec2> texcoords_;
    std::vector<glm::uvec3> texcoords_of_;  // the corners of each face
    std::vector<std::string> groups_;       // of the faces to come
    std::string object_;
};

}  // namespace

TriangleMesh load_obj(const std::filesystem::path& path)
{
    TriangleMesh mesh = ObjReader(read_text(path), path.string()).mesh();
    check_mesh(mesh, path.string());
    return mesh;
}

}  // namespace nuno
