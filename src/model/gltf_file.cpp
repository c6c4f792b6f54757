// glTF 2.0 (Khronos, ISO/IEC 12113): a header, a chunk of JSON, a chunk of bytes.
#include "model/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include <glm/common.hpp>

#include "core/error.h"
#include "core/version.h"
#include "model/smooth_normals.h"

namespace nuno {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF holds little-endian numbers");

using Json = nlohmann::ordered_json;

// Numbers of the specification.
enum : int
{
    kFloat = 5126,
    kUint = 5125,
    kArrayBuffer = 34962,
    kElementBuffer = 34963,
    kRepeat = 10497,
    kLinear = 9729,
    kMipmaps = 9987
};

constexpr std::uint32_t kMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBytesChunk = 0x004e4942;
constexpr double kMostBytes = 4294967295.0;  // lengths have 32 bits

template <class T>
std::size_t append(std::vector<std::byte>& bytes, const std::vector<T>& values)
{
    const std::size_t offset = bytes.size();
    const auto more = std::as_bytes(std::span(values));
    bytes.insert(bytes.end(), more.begin(), more.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
    return offset;
}

// Adds to a list of the file; its number there.
std::size_t add_to(Json& json, const char* list, Json entry)
{
    json[list].push_back(std::move(entry));
    return json[list].size() - 1;
}

std::size_t add_view(Json& json, std::size_t offset, std::size_t length)
{
    return add_to(json, "bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
}

// Of one T for each vertex, which several accessors may use.
template <class T>
std::size_t add_vertex_view(Json& json, std::size_t offset, std::size_t length)
{
    const std::size_t view = add_view(json, offset, length);
    json["bufferViews"][view]["byteStride"] = sizeof(T);
    json["bufferViews"][view]["target"] = kArrayBuffer;
    return view;
}

struct Place
{
    std::size_t view, offset, count;
};

std::size_t add_accessor(Json& json, Place place, int component, const char* type)
{
    return add_to(json, "accessors",
                  {{"bufferView", place.view},
                   {"byteOffset", place.offset},
                   {"componentType", component},
                   {"count", place.count},
                   {"type", type}});
}

void set_box(Json& accessor, const GltfBox& box)
{
    accessor["min"] = {box.low.x, box.low.y, box.low.z};
    accessor["max"] = {box.high.x, box.high.y, box.high.z};
}

GltfBox box_of(std::span<const glm::vec3> points)
{
    GltfBox box{points[0], points[0]};
    for (const glm::vec3& p : points) box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
    return box;
}

// Vectors of a part in a view of them; `first`: that of the first vertex of the cloth.
std::size_t add_vectors(Json& json, std::size_t view, std::size_t first, const GltfPart& part)
{
    const std::size_t offset = (first + part.first_vertex) * sizeof(glm::vec3);
    return add_accessor(json, {view, offset, part.vertex_count}, kFloat, "VEC3");
}

// Of an sRGB colour of 8 bits.
double linear(int value) { return std::pow((value / 255.0 + 0.055) / 1.055, 2.4); }

Json material_of(const GltfPart& part, Json& json, std::vector<std::byte>& bytes)
{
    Json surface{{"metallicFactor", 0}, {"roughnessFactor", 0.9}};
    if (part.png.empty()) {
        surface["baseColorFactor"] = {linear(222), linear(216), linear(205), 1};
    } else {
        const std::size_t view = add_view(json, append(bytes, part.png), part.png.size());
        const std::size_t image = add_to(json, "images", {{"bufferView", view}, {"mimeType", "image/png"}});
        if (!json.contains("samplers"))
            add_to(json, "samplers",
                   {{"magFilter", kLinear}, {"minFilter", kMipmaps}, {"wrapS", kRepeat}, {"wrapT", kRepeat}});
        surface["baseColorTexture"] = {{"index", add_to(json, "textures", {{"sampler", 0}, {"source", image}})}};
    }
    return {{"name", part.name}, {"pbrMetallicRoughness", surface}, {"doubleSided", true}};
}

template <std::size_t N>
void append_words(WholeFile& file, const std::array<std::uint32_t, N>& words)
{
    file.append(std::as_bytes(std::span(words)));
}

}  // namespace

void split_at_seams(GltfCloth& cloth, const TextureSeams& seams)
{
    if (seams.empty()) return;
    const auto count = static_cast<std::uint32_t>(cloth.uvs.size());
    std::vector<std::uint32_t> place(count + seams.vertices.size());
    std::vector<glm::vec2> uvs;
    cloth.vertices.clear();
    const auto take = [&](std::uint32_t number, std::uint32_t vertex, glm::vec2 uv) {
        place[number] = static_cast<std::uint32_t>(uvs.size());
        cloth.vertices.push_back(vertex);
        uvs.push_back(uv);
    };
    for (GltfPart& part : cloth.parts) {
        const std::uint32_t first = part.first_vertex, end = first + part.vertex_count;
        part.first_vertex = static_cast<std::uint32_t>(uvs.size());
        for (std::uint32_t vertex = first; vertex < end; ++vertex) take(vertex, vertex, cloth.uvs[vertex]);
        for (std::uint32_t copy = 0; copy < seams.vertices.size(); ++copy)
            if (seams.vertices[copy] >= first && seams.vertices[copy] < end)
                take(count + copy, seams.vertices[copy], seams.uvs[copy]);
        part.vertex_count = static_cast<std::uint32_t>(uvs.size()) - part.first_vertex;
    }
    cloth.uvs = std::move(uvs);
    cloth.faces = seams.faces;
    for (glm::uvec3& face : cloth.faces)
        for (int k = 0; k < 3; ++k) face[k] = place[face[k]];
}

GltfFile::GltfFile(const std::filesystem::path& path, GltfCloth cloth)
    : cloth_(std::move(cloth)), simulated_faces_(cloth_.faces), file_(path), moves_(path.string() + ".frames")
{
    if (cloth_.vertices.empty()) {
        cloth_.vertices.resize(cloth_.uvs.size());
        std::iota(cloth_.vertices.begin(), cloth_.vertices.end(), 0u);
    }
    for (glm::uvec3& face : simulated_faces_)
        for (int k = 0; k < 3; ++k) face[k] = cloth_.vertices[face[k]];
}

void GltfFile::add(std::span<const glm::vec4> positions, double time_s)
{
    const std::vector<glm::vec3> normals = smooth_normals(positions, simulated_faces_);
    std::vector<glm::vec3> frame;
    frame.reserve(2 * cloth_.vertices.size());
    for (const std::uint32_t vertex : cloth_.vertices) frame.emplace_back(positions[vertex]);
    for (const std::uint32_t vertex : cloth_.vertices) frame.push_back(normals[vertex]);
    if (first_.empty()) {
        first_ = frame;
    } else {
        for (std::size_t i = 0; i < frame.size(); ++i) frame[i] -= first_[i];
        const double weights = double(times_.size() + 1) * double(times_.size()) * sizeof(float);
        if (double(moves_.size()) + double(std::span(frame).size_bytes()) + weights > kMostBytes * 0.9)
            throw Error(
                fmt::format("--gltf: {} frames are all that the 4 GiB of a glTF file hold; write fewer with "
                            "--frames or --every, or a --pc2",
                            times_.size()));
        moves_.append(std::as_bytes(std::span(frame)));
    }
    times_.push_back(static_cast<float>(time_s));
    for (const GltfPart& part : cloth_.parts)
        boxes_.push_back(box_of(std::span(frame).subspan(part.first_vertex, part.vertex_count)));
}

void GltfFile::add_cloth(Json& json, std::vector<std::byte>& bytes) const
{
    std::vector<glm::vec2> uvs;  // v runs downwards here
    for (const glm::vec2& uv : cloth_.uvs) uvs.emplace_back(uv.x * cloth_.repeats, 1 - uv.y * cloth_.repeats);
    std::vector<glm::uvec3> faces = cloth_.faces;  // of each part from its first vertex on
    for (const GltfPart& part : cloth_.parts)
        for (std::uint32_t f = 0; f < part.face_count; ++f) faces[part.first_face + f] -= part.first_vertex;
    const std::size_t points = add_vertex_view<glm::vec3>(json, append(bytes, first_), std::span(first_).size_bytes());
    const std::size_t places = add_vertex_view<glm::vec2>(json, append(bytes, uvs), std::span(uvs).size_bytes());
    const std::size_t corners = add_view(json, append(bytes, faces), std::span(faces).size_bytes());
    json["bufferViews"][corners]["target"] = kElementBuffer;
    for (std::size_t p = 0; p < cloth_.parts.size(); ++p) {
        const GltfPart& part = cloth_.parts[p];
        const std::size_t position = add_vectors(json, points, 0, part);
        set_box(json["accessors"][position], boxes_[p]);
        const std::size_t normal = add_vectors(json, points, uvs.size(), part);
        const std::size_t uv =
            add_accessor(json, {places, part.first_vertex * sizeof(glm::vec2), part.vertex_count}, kFloat, "VEC2");
        const std::size_t index = add_accessor(
            json, {corners, part.first_face * sizeof(glm::uvec3), 3 * std::size_t(part.face_count)}, kUint, "SCALAR");
        const std::size_t material = add_to(json, "materials", material_of(part, json, bytes));
        const Json primitive{{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}},
                             {"indices", index},
                             {"material", material}};
        add_to(json, "meshes", {{"name", part.name}, {"primitives", Json::array({primitive})}});
        add_to(json, "nodes", {{"name", part.name}, {"mesh", p}});
        json["scenes"][0]["nodes"].push_back(p);
    }
}

// `start`: of the moves among the bytes of the file.
void GltfFile::add_targets(Json& json, std::size_t start) const
{
    const std::size_t frame_bytes = std::span(first_).size_bytes(), part_count = cloth_.parts.size();
    for (std::size_t k = 0; k < target_count(); ++k) {
        const std::size_t view = add_vertex_view<glm::vec3>(json, start + k * frame_bytes, frame_bytes);
        for (std::size_t p = 0; p < part_count; ++p) {
            const std::size_t position = add_vectors(json, view, 0, cloth_.parts[p]);
            set_box(json["accessors"][position], boxes_[(k + 1) * part_count + p]);
            const std::size_t normal = add_vectors(json, view, cloth_.uvs.size(), cloth_.parts[p]);
            json["meshes"][p]["primitives"][0]["targets"].push_back({{"POSITION", position}, {"NORMAL", normal}});
        }
    }
    for (Json& mesh : json["meshes"]) mesh["weights"] = std::vector<int>(target_count(), 0);
}

// At its own time the weight of a target is 1 and that of every other 0; linear between times.
void GltfFile::add_animation(Json& json, std::vector<std::byte>& bytes) const
{
    std::vector<float> weights(times_.size() * target_count());
    for (std::size_t k = 1; k < times_.size(); ++k) weights[k * target_count() + k - 1] = 1;
    const std::size_t times_view = add_view(json, append(bytes, times_), std::span(times_).size_bytes());
    const std::size_t weights_view = add_view(json, append(bytes, weights), std::span(weights).size_bytes());
    const std::size_t input = add_accessor(json, {times_view, 0, times_.size()}, kFloat, "SCALAR");
    json["accessors"][input]["min"] = Json::array({times_.front()});
    json["accessors"][input]["max"] = Json::array({times_.back()});
    const std::size_t output = add_accessor(json, {weights_view, 0, weights.size()}, kFloat, "SCALAR");
    Json channels = Json::array();
    for (std::size_t p = 0; p < cloth_.parts.size(); ++p)
        channels.push_back({{"sampler", 0}, {"target", {{"node", p}, {"path", "weights"}}}});
    const Json sampler{{"input", input}, {"interpolation", "LINEAR"}, {"output", output}};
    add_to(json, "animations", {{"name", "cloth"}, {"samplers", Json::array({sampler})}, {"channels", channels}});
}

void GltfFile::finish()
{
    if (times_.empty()) return;
    Json json{{"asset", {{"version", "2.0"}, {"generator", fmt::format("nuno {}", kVersion)}}}, {"scene", 0}};
    std::vector<std::byte> bytes;
    add_cloth(json, bytes);
    if (target_count() > 0) {
        add_animation(json, bytes);
        add_targets(json, bytes.size());
    }
    const std::size_t length = bytes.size() + moves_.size();
    json["buffers"] = Json::array({{{"byteLength", length}}});
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + 8 + length;
    const auto word = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    append_words<5>(file_, {kMagic, 2, word(total), word(text.size()), kJsonChunk});
    file_.append(std::as_bytes(std::span(text)));
    append_words<2>(file_, {word(length), kBytesChunk});
    file_.append(bytes);
    file_.append_all_of(moves_);
    file_.commit();
}

}  // namespace nuno
